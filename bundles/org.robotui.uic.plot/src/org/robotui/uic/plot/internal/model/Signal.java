package org.robotui.uic.plot.internal.model;

import java.util.Optional;
import org.robotui.uic.plot.internal.signal.Expr;

/** What a configured text means, or why it means nothing. */
record Signal(Optional<Expr> expr, Optional<String> error) {
  static Signal of(String text, SignalNames names) {
    try {
      return new Signal(Optional.of(names.read(text)), Optional.empty());
    } catch (IllegalArgumentException e) {
      return new Signal(Optional.empty(), Optional.of(e.getMessage()));
    }
  }
}
