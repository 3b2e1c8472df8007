-- Drives `rospkg server` by Neovim's own client: opens a manifest, breaks it, applies an action, and says what it saw.
-- $FILE is the manifest, $ROOT the workspace, $ROSPKG the program.
vim.cmd("edit " .. vim.fn.getenv("FILE"))
local root = vim.fn.getenv("ROOT")
local id = vim.lsp.start_client({
  name = "rospkg",
  cmd = { vim.fn.getenv("ROSPKG"), "server" },
  root_dir = root,
  init_options = { answerWithin = 60 }, -- the machine of the tests may be slow
  workspace_folders = { { uri = vim.uri_from_fname(root), name = "ws" } },
})
vim.lsp.buf_attach_client(0, id)

local function codes()
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do
    table.insert(found, each.code)
  end
  table.sort(found)
  return table.concat(found, " ")
end

local function say(what, holds)
  local came = vim.wait(30000, holds, 50)
  io.stdout:write(what, ": ", came and "yes" or "no", " [", codes(), "]\n")
end

local function replace(pattern, text)
  for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, false)) do
    if line:find(pattern) then
      vim.api.nvim_buf_set_lines(0, number - 1, number, false, text)
      return
    end
  end
end

replace("<description>", { "  <description>TODO</description>" })
say("a finding comes", function() return codes() == "XML104" end)
vim.cmd("silent undo")
say("it goes", function() return codes() == "" end)

replace("<export>", { "  <exec_depend>rclpy</exec_depend>", "  <exec_depend>rclpy</exec_depend>", "  <export>" })
say("a duplicate is told", function() return codes():find("XML201") ~= nil end)
local whole = { start = { line = 0, character = 0 }, ["end"] = { line = 99, character = 0 } }
local asked = { textDocument = vim.lsp.util.make_text_document_params(), range = whole, context = { diagnostics = {} } }
local function apply_preferred()
  for _, answer in pairs(vim.lsp.buf_request_sync(0, "textDocument/codeAction", asked, 30000) or {}) do
    for _, action in ipairs(answer.result or {}) do
      if action.isPreferred then
        vim.lsp.util.apply_workspace_edit(action.edit, "utf-16")
        return true
      end
    end
  end
end
apply_preferred()
say("its action removes it", function() return not codes():find("XML201") end)
vim.api.nvim_win_set_cursor(0, { 1, 0 })
vim.fn.search("<depend>my_o")
vim.cmd("normal 10l")
vim.lsp.buf.definition()
say("a definition opens", function() return vim.fn.expand("%:p"):find("my_other/package.xml", 1, true) ~= nil end)
vim.cmd("buffer 1")
io.stdout:write(table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\n"), "\n")
vim.cmd("qa!")
