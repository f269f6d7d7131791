package org.robotui.uic.tftree.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.LongToDoubleFunction;
import java.util.stream.Collectors;
import org.robotui.api.frame.FrameRefusal;
import org.robotui.data.FrameId;
import org.robotui.ui.Health;

/** What is wrong with the frames as a whole, the worst first. Pure. */
final class Notices {
  private static final int NAMED = 4;
  private static final double LATELY = 15;

  private Notices() {}

  static List<Notice> of(Forest forest, List<FrameRow> rows, List<FrameRefusal> refusals, LongToDoubleFunction ages) {
    List<Notice> notices = new ArrayList<>();
    refusals.stream().filter(refusal -> ages.applyAsDouble(refusal.receivedNanos()) <= LATELY).limit(NAMED)
        .forEach(refusal -> notices
            .add(new Notice(Health.BAD, "Refused of " + sender(refusal.authority()) + ": " + refusal.reason()
                + (refusal.count() > 1 ? " (" + refusal.count() + " times)" : ""))));
    counted(notices, Health.BAD, rows.stream().filter(row -> row.health() == Health.BAD).toList(),
        " is published by two at once: ", " are published by two at once: ");
    counted(notices, Health.STALE, rows.stream().filter(row -> row.health() == Health.STALE).toList(), " is stale: ",
        " are stale: ");
    trees(forest, notices);
    return List.copyOf(notices);
  }

  private static String sender(String authority) {
    return authority.isBlank() ? "a robot" : authority;
  }

  private static void counted(List<Notice> notices, Health health, List<FrameRow> rows, String one, String many) {
    if (!rows.isEmpty()) {
      String names = rows.stream().limit(NAMED).map(FrameRow::title).collect(Collectors.joining(", "))
          + (rows.size() > NAMED ? ", \u2026" : "");
      notices.add(new Notice(health, (rows.size() == 1 ? "1 frame" + one : rows.size() + " frames" + many) + names));
    }
  }

  /** Several trees of one robot are a fault; those of several robots are not linked unless somebody says so. */
  private static void trees(Forest forest, List<Notice> notices) {
    Map<String, List<FrameId>> byRobot =
        forest.roots().stream().collect(Collectors.groupingBy(FrameId::robot, TreeMap::new, Collectors.toList()));
    byRobot.forEach((robot, roots) -> {
      if (roots.size() > 1) {
        notices.add(
            new Notice(Health.WARNING, "The frames of " + robot + " are " + roots.size() + " trees, no transform links "
                + names(roots)));
      }
    });
    if (byRobot.size() > 1) {
      notices.add(new Notice(Health.NONE, "No transform links the robots " + String.join(", ", byRobot.keySet())
          + "; the configuration can set one"));
    }
  }

  private static String names(List<FrameId> roots) {
    return roots.stream().limit(NAMED).map(FrameId::name).collect(Collectors.joining(", "))
        + (roots.size() > NAMED ? ", \u2026" : "");
  }
}
