package org.robotui.uic.plugins.internal.model;

import java.util.Optional;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.LoopTiming;

/**
 * What was read when the user reset the figures.
 *
 * @param plugins how often and how long they were called
 * @param timing how well threads kept their time, where that is told
 * @param nanos when that was
 */
record Baseline(ControlPlugins plugins, Optional<LoopTiming> timing, long nanos) {
  Optional<LoopTiming.Loop> loop(LoopTiming.Loop now) {
    return timing.stream().flatMap(t -> t.loops().stream())
        .filter(loop -> loop.process().equals(now.process()) && loop.name().equals(now.name())).findFirst();
  }

  /** A plugin whose process was started again counts from zero. */
  Optional<ControlPlugins.Plugin> plugin(ControlPlugins.Plugin now) {
    return plugins.plugins().stream()
        .filter(plugin -> plugin.name().equals(now.name()) && plugin.respawns() == now.respawns()
            && plugin.cycles() <= now.cycles())
        .findFirst();
  }
}
