package org.robotui.core.internal.life;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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

  /** Names the threads that components which have ended started by themselves on threads that are not their own. */
  default List<String> strays(Collection<? extends Instance> ended) {
    Map<String, Instance> firsts = new LinkedHashMap<>();
    ended.forEach(i -> services().registry().bundle(i.type()).ifPresent(bundle -> firsts.putIfAbsent(bundle, i)));
    Map<String, List<String>> found = Strays.of(firsts.keySet(), services().bundles());
    return firsts.entrySet().stream().filter(first -> found.containsKey(first.getKey()))
        .map(first -> first.getValue()
            .left("left threads that no factory made: " + String.join(", ", found.get(first.getKey()))))
        .toList();
  }
}
