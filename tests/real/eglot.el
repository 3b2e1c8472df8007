;; Drives `rospkg server` by Emacs' eglot: opens a manifest, breaks it, mends it, and says what flymake shows.
;; $FILE is the manifest, $ROOT the workspace, $ROSPKG the program.
(package-initialize)
(require 'eglot)
(setq eglot-sync-connect 30 make-backup-files nil)
(find-file (getenv "FILE"))
(nxml-mode)
(eglot '(nxml-mode) (cons 'transient (getenv "ROOT")) 'eglot-lsp-server (list (getenv "ROSPKG") "server") "xml")

(defun texts () (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))

(defun say (what holds)
  (let ((left 600))
    (while (and (> left 0) (not (funcall holds)))
      (accept-process-output nil 0.1)
      (setq left (1- left)))
    (princ (format "%s: %s %S\n" what (if (funcall holds) "yes" "no") (texts)))))

(defun type-over (old new)
  (goto-char (point-min))
  (search-forward old)
  (replace-match new)
  (eglot--signal-textDocument/didChange))

(type-over "Drives my robot" "TODO")
(say "a finding comes" (lambda () (and (texts) (string-match-p "XML104" (car (texts))))))
(type-over "TODO" "Drives my robot")
(say "it goes" (lambda () (not (texts))))
(set-buffer-modified-p nil)
(kill-emacs 0)
