package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.robotui.uic.parameters.internal.model.ParameterRow.State;

/** Makes the rows of the tree: what is open, or all that a filter leaves. */
final class RowMaker {
  private final Values values;
  private long looked;

  RowMaker(Values values) {
    this.values = values;
  }

  List<ParameterRow> rows(Directory directory, Set<Key> open, String filter) {
    String[] words = filter.isBlank() ? new String[0] : filter.strip().toLowerCase(Locale.ROOT).split("\\s+");
    List<ParameterRow> rows = new ArrayList<>();
    boolean several = directory.trees().size() > 1;
    for (Branch tree : directory.trees()) {
      if (several) {
        add(rows, tree, 0, open, words);
      } else {
        tree.children().forEach(child -> add(rows, child, 0, open, words));
      }
    }
    return List.copyOf(rows);
  }

  /** How many branches were looked at so far, for tests of what it costs. */
  long looked() {
    return looked;
  }

  private boolean add(List<ParameterRow> rows, Branch branch, int depth, Set<Key> open, String... words) {
    looked++;
    boolean filtered = words.length > 0;
    boolean shown = filtered || open.contains(branch.key());
    int at = rows.size();
    rows.add(row(branch, depth, shown));
    boolean fits = !filtered || branch.parameter() && matches(rows.get(at), words);
    if (branch.isNamespace() && shown) {
      for (Branch child : branch.children()) {
        fits |= add(rows, child, depth + 1, open, words);
      }
    }
    if (!fits) {
      rows.remove(at);
    }
    return fits;
  }

  private ParameterRow row(Branch branch, int depth, boolean open) {
    Optional<Held> held = branch.parameter() ? values.get(branch.key()) : Optional.empty();
    Optional<Object> value = held.flatMap(Held::value);
    return new ParameterRow(branch.key(), depth, branch.label(), branch.isNamespace(), open, branch.leaves(),
        branch.parameter(), value,
        text(branch, held), value.map(ValueText::type).orElse(""), state(branch, held),
        held.filter(Held::changed).flatMap(Held::first).map(Held::line));
  }

  private static String text(Branch branch, Optional<Held> held) {
    if (!branch.parameter()) {
      return "";
    }
    String value = held.map(Held::text).orElse("");
    Optional<String> problem = held.flatMap(Held::problem);
    return problem.map(why -> value.isEmpty() ? why : value + "  \u2014  " + why)
        .orElseGet(() -> held.isEmpty() ? "\u2026" : held.get().value().isEmpty() ? "not set any more" : value);
  }

  private static State state(Branch branch, Optional<Held> held) {
    if (held.flatMap(Held::problem).isPresent()) {
      return State.WRONG;
    }
    if (branch.parameter() && (held.isEmpty() || held.get().busy())) {
      return State.BUSY;
    }
    return held.filter(Held::changed).isPresent() ? State.CHANGED : State.KNOWN;
  }

  private static boolean matches(ParameterRow row, String... words) {
    String text = (row.key().name() + " " + row.text()).toLowerCase(Locale.ROOT);
    for (String word : words) {
      if (!text.contains(word)) {
        return false;
      }
    }
    return true;
  }
}
