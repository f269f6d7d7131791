package org.robotui.uic.plugins.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.port.InputState;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.ask.ControlFirst;

/**
 * All that the view shows, at one moment.
 *
 * @param state of what is told of the plugins
 * @param groups threads with their plugins
 * @param drives those of the joints, where there are some; below the first thread, which is that of the hardware
 * @param realTime whether times are guaranteed, where that is told
 * @param sinceReset how long ago the figures were reset, seconds, where they were
 * @param told by plugin: what became of what was asked
 * @param question whether to take over from somebody
 * @param switchable whether there is a control that switches plugins
 */
public record PluginsLook(InputState state, List<Group> groups, Optional<DrivesLine> drives,
    Optional<Boolean> realTime, Optional<Long> sinceReset, Map<String, PluginNotice> told,
    Optional<ControlFirst.Question> question, boolean switchable) {
  /** Copies the list and the map. */
  public PluginsLook {
    groups = List.copyOf(groups);
    told = Map.copyOf(told);
  }

  /** All lines in their order. */
  public List<Line> lines() {
    List<Line> lines = new ArrayList<>();
    groups.forEach(group -> {
      lines.add(group.loop());
      lines.addAll(group.plugins());
    });
    drives.ifPresent(line -> lines.add(Math.min(1, lines.size()), line));
    return List.copyOf(lines);
  }

  /** The thread of a line. */
  public Optional<LoopLine> loop(Line line) {
    return groups.stream()
        .filter(group -> line instanceof DrivesLine || group.loop().key().equals(line.key())
            || group.plugins().stream().anyMatch(p -> p.key().equals(line.key())))
        .map(Group::loop).findFirst();
  }

  /** Whether it is told that no time is guaranteed. */
  public boolean isNotRealTime() {
    return realTime.filter(real -> !real).isPresent();
  }

  /** Whether plugins can be switched now: nobody switches what is not seen. */
  public boolean usable() {
    return switchable && state instanceof InputState.Live;
  }

  /** How old all is, where it is not told any more; else empty. */
  public String stale() {
    return state instanceof InputState.Stale ? StateView.word(state) : "";
  }

  /** From when on the figures count. */
  public String since() {
    return sinceReset.map(seconds -> "since the reset " + Figures.age(seconds) + " ago").orElse("since the start");
  }

  /** What stands at the right of the view's title. */
  public String note() {
    List<PluginLine> plugins = groups.stream().flatMap(group -> group.plugins().stream()).toList();
    long running = plugins.stream().filter(p -> p.plugin().state() == State.RUNNING).count();
    long failed = plugins.stream().filter(p -> p.plugin().state() == State.FAILED).count();
    return Stream.of(
        plugins.isEmpty() ? "" : running + " of " + plugins.size() + " running",
        failed == 0 ? "" : failed + " failed",
        drives.filter(line -> line.health() != Health.OK).map(line -> "drives: " + line.word()).orElse(""),
        isNotRealTime() ? "no real-time rights" : "",
        StateView.word(state))
        .filter(part -> !part.isEmpty()).collect(Collectors.joining(" \u00b7 "));
  }
}
