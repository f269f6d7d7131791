package org.robotui.workbench.internal.model;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.link.LinkState;

/**
 * How all robots are doing at one moment, as navigator and status line show it. Safe for all threads.
 *
 * @param robots a row each
 * @param details of those that a window shows, by name
 */
public record Overview(List<RobotRow> robots, Map<String, Detail> details) {
  /** Before anybody looked. */
  public static final Overview NOTHING = new Overview(List.of(), Map.of());

  /**
   * More of one robot.
   *
   * @param ports a row each
   * @param status the line at the bottom of its window
   * @param link how it is reached
   */
  public record Detail(List<PortRow> ports, StatusText status, LinkState link) {
    /** Where a window shows no robot. */
    public static final Detail NONE = new Detail(List.of(), StatusText.NONE, new LinkState.Disconnected());

    /** Looks at a robot now. */
    public static Detail of(Ruic ruic) {
      return of(ruic, ruic.snapshot());
    }

    private static Detail of(Ruic ruic, RuicSnapshot now) {
      return new Detail(PortRow.of(now), StatusText.of(now, ruic.clock()), now.link());
    }
  }

  /** Looks at all robots now; takes as long as they have ports. */
  public static Overview of(List<Ruic> ruics, Set<String> shown) {
    Map<Ruic, RuicSnapshot> now = ruics.stream().collect(Collectors.toMap(Function.identity(), Ruic::snapshot));
    return new Overview(ruics.stream().map(now::get).map(RobotRow::of).toList(),
        ruics.stream().filter(r -> shown.contains(r.name()))
            .collect(Collectors.toMap(Ruic::name, r -> Detail.of(r, now.get(r)))));
  }

  /** What is known of a robot; of one that was not shown before, what is so now. */
  public Detail detail(Ruic ruic) {
    Detail known = details.get(ruic.name());
    return known == null ? Detail.of(ruic) : known;
  }
}
