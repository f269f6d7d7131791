package org.robotui.uic.jointcontrol.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.joint.JointControl.Source;
import org.robotui.data.joint.JointModel;
import org.robotui.ui.Health;

/** Makes the lines of the table. Pure. */
public final class Lines {
  private static final List<Health> WORST = List.of(Health.BAD, Health.WARNING, Health.OK);

  private Lines() {}

  /**
   * The lines.
   *
   * @param look what is known
   * @param words all of which a joint must have in its name, chain, owner or source
   * @param closed chains whose joints are not listed
   * @param sorting inside a chain
   * @return the lines, in order
   */
  public static List<JointLine> of(ControlLook look, String words, Set<String> closed, Sorting sorting) {
    List<String> wanted = Stream.of(words.strip().toLowerCase(Locale.ROOT).split("\\s+")).toList();
    List<JointLine> lines = new ArrayList<>();
    for (JointModel.Chain chain : look.joints().chains()) {
      List<JointRow> rows = rows(look, chain).stream().filter(row -> fits(row, wanted)).toList();
      boolean open = !closed.contains(chain.name());
      if (!rows.isEmpty() && isHeaded(look.joints())) {
        lines.add(head(chain.name(), rows, open));
      }
      if (open) {
        lines.addAll(sorting.order().map(order -> rows.stream().sorted(order).toList()).orElse(rows));
      }
    }
    return List.copyOf(lines);
  }

  /** Where the robot has no chains there is nothing to be told apart. */
  private static boolean isHeaded(Joints joints) {
    return joints.chains().stream().anyMatch(chain -> !chain.name().isEmpty());
  }

  private static List<JointRow> rows(ControlLook look, JointModel.Chain chain) {
    Map<String, Aim> aims = look.drive().aims();
    return chain.joints().stream().map(look.joints().byName()::get)
        .map(seen -> new JointRow(chain.name(), seen.model(), seen.state(),
            Optional.ofNullable(aims.get(seen.model().name())),
            new Measure(seen.model().type(), look.degrees())))
        .toList();
  }

  private static boolean fits(JointRow row, List<String> wanted) {
    String text = String
        .join(" ", row.name(), row.chain(), row.state().owner(), row.source(), row.state().faults() == 0 ? "" : "fault")
        .toLowerCase(Locale.ROOT);
    return wanted.stream().allMatch(text::contains);
  }

  private static ChainHead head(String chain, List<JointRow> rows, boolean open) {
    List<Health> all = rows.stream().map(JointRow::health).toList();
    Health worst = WORST.stream().filter(all::contains).findFirst().orElse(Health.NONE);
    return new ChainHead(chain, rows.size(), words(rows), worst, open);
  }

  /** Counts what is not all the same. */
  static String words(List<JointRow> rows) {
    long faults = rows.stream().filter(row -> row.state().faults() != 0).count();
    Map<Source, Long> counts =
        rows.stream().collect(Collectors.groupingBy(row -> row.state().source(), Collectors.counting()));
    String sources = counts.entrySet().stream().sorted(Map.Entry.comparingByKey(Comparator.reverseOrder()))
        .map(e -> counts.size() == 1 ? "all " + word(e.getKey()) : e.getValue() + " " + word(e.getKey()))
        .collect(Collectors.joining(", "));
    return (rows.size() == 1 ? "1 joint" : rows.size() + " joints") + ", "
        + (rows.size() == 1 ? sources.replace("all ", "") : sources)
        + (faults == 0 ? "" : faults == 1 ? ", 1 fault" : ", " + faults + " faults");
  }

  private static String word(Source source) {
    return switch (source) {
      case COMMANDED -> "commanded";
      case HOLDING -> "holding";
      case SAFE -> "in safe state";
      case FREE -> "free";
    };
  }
}
