package org.robotui.core.internal.life;

import java.util.List;
import org.robotui.api.ComponentType;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.core.internal.time.RuicFrames;

/** Where a robot interface runs: in a RUIC, or on trial for one that may come. */
interface ComponentHome {
  /** The RUIC's name. */
  String ruicName();

  /** Of the host. */
  Services services();

  /** Its clock. */
  RuicClock clock();

  /** Its frames. */
  RuicFrames frames();

  /** What to do when things change. */
  RuicParts.Wake wake();

  /** Names the threads that a component started by itself on a thread that is not its own; empty where there are none. */
  default String strays(ComponentType type) {
    List<String> names = services().registry().bundle(type)
        .map(bundle -> Strays.of(bundle, services().bundles())).orElse(List.of()).stream().map(Thread::getName).sorted().toList();
    return names.isEmpty() ? "" : "; threads left that no factory made: " + String.join(", ", names);
  }
}
