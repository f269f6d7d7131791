package org.robotui.uic.plugins.internal.model;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.UicContext;
import org.robotui.api.port.Caller;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.PluginReply;
import org.robotui.api.port.PluginRequest;
import org.robotui.data.Data;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.data.control.Drives;
import org.robotui.data.control.LoopTiming;
import org.robotui.ui.StateView;
import org.robotui.ui.ask.ControlFirst;

/** Takes what is told of plugins and threads. Ticked by one thread; the look, the verbs and the reset are for all. */
public final class PluginsModel {
  private static final long SECOND = 1_000_000_000L;

  private final Input<ControlPlugins> plugins;
  private final Input<LoopTiming> timing;
  private final Input<Drives> drives;
  private final ControlFirst control;
  private final Verbs verbs;
  private Optional<Baseline> baseline = Optional.empty();
  private Map<String, State> states = Map.of();
  private Optional<Drives> told = Optional.empty();
  private volatile PluginsLook look;

  /** With the inputs and the control that switches plugins. */
  public PluginsModel(UicContext context, Input<ControlPlugins> plugins, Input<LoopTiming> timing,
      Input<Drives> drives, Caller<PluginRequest, PluginReply> caller, Supplier<Duration> timeout) {
    this.plugins = plugins;
    this.timing = timing;
    this.drives = drives;
    control = new ControlFirst(context);
    verbs = new Verbs(caller, control, timeout);
    look = now(System.nanoTime());
  }

  /** Takes what came; whether anything is new. */
  public synchronized boolean tick(long nowNanos) {
    watchStates();
    PluginsLook next = now(nowNanos);
    boolean changed = !next.equals(look);
    look = next;
    return changed;
  }

  /** What is to be shown. */
  public PluginsLook look() {
    return look;
  }

  /** What plugins are asked by. */
  public Verbs verbs() {
    return verbs;
  }

  /** Who has control of the robot. */
  public ControlFirst control() {
    return control;
  }

  /** Has all figures count from now on. */
  public synchronized void reset(long nowNanos) {
    baseline = newest(plugins).map(told -> new Baseline(told, newest(timing), nowNanos));
    tick(nowNanos);
  }

  /** Has all figures count from the start again. */
  public synchronized void sinceStart(long nowNanos) {
    baseline = Optional.empty();
    tick(nowNanos);
  }

  private void watchStates() {
    Map<String, State> current = new HashMap<>();
    newest(plugins).ifPresent(told -> told.plugins().forEach(plugin -> current.put(plugin.name(), plugin.state())));
    current.forEach((name, state) -> {
      if (states.containsKey(name) && states.get(name) != state) {
        verbs.changed(name);
      }
    });
    states = Map.copyOf(current);
    if (!told.equals(newest(drives))) {
      told = newest(drives);
      verbs.changed(DrivesLine.ALL);
    }
  }

  private PluginsLook now(long nowNanos) {
    Optional<LoopTiming> measured = StateView.showsContent(timing.state()) ? newest(timing) : Optional.empty();
    List<Group> groups = StateView.showsContent(plugins.state())
        ? newest(plugins).map(told -> Group.of(told, measured, baseline, verbs::isPending)).orElse(List.of())
        : List.of();
    Optional<DrivesLine> line = groups.isEmpty() || !StateView.showsContent(drives.state()) ? Optional.empty()
        : newest(drives).flatMap(now -> DrivesLine.of(now, verbs.isPending(DrivesLine.ALL)));
    return new PluginsLook(plugins.state(), groups, line, measured.map(LoopTiming::realTime),
        baseline.map(b -> (nowNanos - b.nanos()) / SECOND),
        verbs.told(), control.question(), verbs.isConnected());
  }

  private static <T extends Data> Optional<T> newest(Input<T> input) {
    return input.latest().map(Envelope::value);
  }
}
