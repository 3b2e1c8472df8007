import { commands, ExtensionContext, window, workspace } from "vscode";
import { LanguageClient, LanguageClientOptions, ServerOptions } from "vscode-languageclient/node";

const PATTERNS = [
  "**/package.xml",
  "**/CMakeLists.txt",
  "**/*.{py,cfg,toml,cmake,launch,xml,xacro,urdf,sdf,yaml,yml,msg,srv,action,cpp,cc,cxx,c,hpp,hh,hxx,h}",
];

let client: LanguageClient | undefined;

export async function activate(context: ExtensionContext): Promise<void> {
  context.subscriptions.push(commands.registerCommand("rospkg.restart", restart));
  context.subscriptions.push(
    workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("rospkg")) {
        void restart();
      }
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}

async function restart(): Promise<void> {
  await client?.stop();
  await start();
}

async function start(): Promise<void> {
  const settings = workspace.getConfiguration("rospkg");
  const command = settings.get<string>("path", "rospkg");
  const environment = settings.get<Record<string, string>>("environment", {});
  const server: ServerOptions = { command, args: ["server"], options: { env: { ...process.env, ...environment } } };
  const options: LanguageClientOptions = {
    documentSelector: PATTERNS.map((pattern) => ({ scheme: "file", pattern })),
    synchronize: { fileEvents: workspace.createFileSystemWatcher("**/*") },
  };
  client = new LanguageClient("rospkg", "rospkg", server, options);
  try {
    await client.start();
  } catch (error) {
    void window.showErrorMessage(
      `rospkg can't be started as \`${command} server\`: ${error}. ` +
        "Install it by pip install 'rospkg-cli[server]', or set rospkg.path.",
    );
  }
}
