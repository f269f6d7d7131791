package org.robotui.uic.diagnostics.internal.view;

import org.robotui.uic.diagnostics.internal.model.Ask;

/** What the user can do with the diagnostics. Display thread; nothing blocks. */
public interface DiagnosticsHands {
  /** Shows something else. */
  void ask(Ask next);

  /** Forgets the parts that do not report any more. */
  void forgetSilent();
}
