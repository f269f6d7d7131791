package org.robotui.uic.plot.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.uic.plot.internal.signal.Expr;
import org.robotui.uic.plot.internal.signal.ExprParser;

/** What the names of a plot mean. One means what stands before it, so that none means itself. Immutable. */
public final class SignalNames {
  private final Map<String, Expr> known = new HashMap<>();
  private final List<String> faults = new ArrayList<>();

  /** Of those of a plot, in their order. */
  public SignalNames(List<NamedSignal> names) {
    Set<String> seen = new HashSet<>();
    for (NamedSignal named : names) {
      if (!seen.add(named.name())) {
        faults.add("the name '" + named.name() + "' is given twice; give each signal one of its own");
      } else {
        define(named);
      }
    }
  }

  private void define(NamedSignal named) {
    try {
      known.put(named.name(), new Expr.Named(named.name(), named.unit(), read(named.signal())));
    } catch (IllegalArgumentException e) {
      faults.add("'" + named.name() + "': " + e.getMessage());
    }
  }

  /**
   * Reads a signal.
   *
   * @throws IllegalArgumentException where the text is none
   */
  public Expr read(String text) {
    return ExprParser.parse(text, name -> Optional.ofNullable(known.get(name)));
  }

  /** What is wrong with them. */
  List<String> faults() {
    return List.copyOf(faults);
  }
}
