package org.robotui.uic.plugins.internal.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.robotui.data.control.ControlPlugins;
import org.robotui.data.control.ControlPlugins.Plugin;
import org.robotui.data.control.LoopTiming;

/**
 * A thread and the plugins that it calls, in the order of the configuration.
 *
 * @param loop the thread
 * @param plugins what it calls
 */
public record Group(LoopLine loop, List<PluginLine> plugins) {
  /** Copies the list. */
  public Group {
    plugins = List.copyOf(plugins);
  }

  /**
   * Puts the plugins below their threads: the measured threads first, in their order, then those that nobody measures.
   */
  static List<Group> of(ControlPlugins plugins, Optional<LoopTiming> timing, Optional<Baseline> baseline,
      Predicate<String> pending) {
    Map<String, LoopLine> loops = new LinkedHashMap<>();
    timing.ifPresent(t -> t.loops().forEach(loop -> {
      LoopLine line = LoopLine.of(loop, baseline.flatMap(b -> b.loop(loop)));
      loops.put(line.key(), line);
    }));
    Map<String, List<PluginLine>> below = new LinkedHashMap<>();
    for (Plugin plugin : plugins.plugins()) {
      LoopLine guess = LoopLine.unmeasured(plugin.process(), plugin.thread(), plugin.period());
      loops.putIfAbsent(guess.key(), guess);
      below.computeIfAbsent(guess.key(), key -> new ArrayList<>())
          .add(PluginLine.of(plugin, baseline.flatMap(b -> b.plugin(plugin)), pending.test(plugin.name())));
    }
    return loops.values().stream().map(loop -> new Group(loop, below.getOrDefault(loop.key(), List.of()))).toList();
  }
}
