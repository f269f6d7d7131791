package org.robotui.uic.plugins.internal.model;

import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.control.LoopTiming.Counts;
import org.robotui.ui.Health;

/**
 * All that is known of the selected line.
 *
 * @param line the line
 * @param loop its thread
 * @param told what became of what was asked of the plugin or the drives
 * @param since from when on the figures count
 * @param usable whether plugins can be switched now
 * @param stale how old all of that is, where it is not told any more; else empty
 */
public record PluginDetail(Line line, LoopLine loop, PluginNotice told, String since, boolean usable, String stale) {
  /** The detail of a line, where it is still there. */
  public static Optional<PluginDetail> of(PluginsLook look, String key) {
    return look.lines().stream().filter(line -> line.key().equals(key)).findFirst()
        .flatMap(line -> look.loop(line).map(loop -> new PluginDetail(line, loop,
            look.told().getOrDefault(subject(line), PluginNotice.NOTHING), look.since(), look.usable(), look.stale())));
  }

  private static String subject(Line line) {
    return line instanceof DrivesLine ? DrivesLine.ALL : line.name();
  }

  /** The drives, where it is those. */
  public Optional<DrivesLine> drives() {
    return line instanceof DrivesLine drives ? Optional.of(drives) : Optional.empty();
  }

  /** Whether something can be asked of it. */
  public boolean isAskable() {
    return !(line instanceof LoopLine);
  }

  /** The plugin, where it is one. */
  public Optional<PluginLine> plugin() {
    return line instanceof PluginLine plugin ? Optional.of(plugin) : Optional.empty();
  }

  /** What it is, behind its name. */
  public String kind() {
    return plugin()
        .map(p -> Stream.of(p.plugin().type(), "in " + loop.name()).filter(part -> !part.isBlank())
            .collect(Collectors.joining(", ")))
        .orElse(drives().isPresent() ? "of the joints" : "thread");
  }

  /** Whether what is seen is old. */
  public boolean isStale() {
    return !stale.isEmpty();
  }

  /** The dot of that. */
  public Health health() {
    return isStale() ? Health.STALE : isAskable() ? line.health() : Health.NONE;
  }

  /** How it is doing, with what it says of itself. */
  public String status() {
    return isStale() ? stale + ", then " + said() : said();
  }

  private String said() {
    return plugin().map(p -> p.word() + (saysNoMore(p) ? "" : ": " + p.plugin().status().strip())
        + (p.plugin().respawns() == 0 ? ""
            : p.plugin().respawns() == 1 ? " \u00b7 its process was started again once"
                : " \u00b7 its process was started again " + p.plugin().respawns() + " times"))
        .or(() -> drives().map(DrivesLine::counted)).orElseGet(loop::scheduled);
  }

  private static boolean saysNoMore(PluginLine plugin) {
    String status = plugin.plugin().status().strip();
    return status.isEmpty() || status.equals(plugin.word());
  }

  /** What is wrong, whole; empty where nothing is. */
  public String problem() {
    String answer = isAskable() && told.health() == Health.BAD ? told.text() : "";
    String error =
        plugin().map(p -> p.plugin().error().strip()).or(() -> drives().map(DrivesLine::problem)).orElse("");
    return Stream.of(answer, error).filter(part -> !part.isBlank()).distinct().collect(Collectors.joining("\n"));
  }

  /** What the thread counted. */
  public String counts() {
    Counts counts = loop.counts();
    return loop.schedule().isEmpty() ? "Its thread is not measured"
        : Durations.count(counts.cycles()) + " cycles \u00b7 "
            + counted(counts.overruns(), "overrun") + " \u00b7 " + Durations.count(counts.missed()) + " missed \u00b7 "
            + counted(counts.allocations(), "allocation") + " \u00b7 " + counted(counts.pageFaults(), "page fault");
  }

  private static String counted(long count, String what) {
    return Durations.count(count) + " " + what + (count == 1 ? "" : "s");
  }

  /** From when on the figures count. */
  public String from() {
    return plugin().filter(p -> !p.busy().isEmpty())
        .map(p -> "Called " + Durations.count(p.busy().histogram().count()) + " times " + since)
        .orElse("Figures " + since);
  }

  /** Whether the counts give reason to look. */
  public Health countsHealth() {
    return loop.schedule().isEmpty() ? Health.NONE : loop.health();
  }
}
