package org.robotui.core.internal.life;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.robotui.api.host.ConfigChange.Step;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.ConnectionConfig;
import org.robotui.core.internal.config.model.RuicConfig;

/**
 * What a RUIC's file says differently. Places do not count: a comment changes nothing.
 *
 * @param written compares robot interfaces
 * @param before as it was written
 * @param after as it is written now
 */
record RuicDiff(Written written, RuicConfig before, RuicConfig after) {
  /** What can be taken up while it runs. */
  List<String> live() {
    List<String> words = new ArrayList<>();
    add(words, "connect", connections(before).equals(connections(after)));
    add(words, "perspectives", before.perspectives().equals(after.perspectives()));
    add(words, "safety", before.safety().equals(after.safety()));
    return words;
  }

  /** What it means for the running RUIC. */
  List<Step> steps() {
    List<Step> steps = new ArrayList<>();
    if (!live().isEmpty()) {
      steps.add(new Step.TakenUp(after.name(), String.join(", ", live())));
    }
    for (ComponentConfig next : after.rfics()) {
      before.rfic(next.id()).filter(old -> !written.same(old, next))
          .ifPresent(old -> steps.add(new Step.Exchanged(after.name(), written.show(next))));
    }
    if (!restart().isEmpty()) {
      steps.add(new Step.NeedsRestart(after.name(), String.join(", ", restart())));
    }
    return steps;
  }

  private List<String> restart() {
    List<String> words = new ArrayList<>();
    add(words, "type", before.type().equals(after.type()) && values(before).equals(values(after)));
    add(words, "rfics", ids(before.rfics()).equals(ids(after.rfics())));
    add(words, "without", before.without().equals(after.without()));
    add(words, "uics",
        before.uics().stream().map(written::show).toList().equals(after.uics().stream().map(written::show).toList()));
    add(words, "layout", before.layout().equals(after.layout()));
    add(words, "frames", before.frames().equals(after.frames()));
    return words;
  }

  private static void add(List<String> words, String word, boolean same) {
    if (!same) {
      words.add(word);
    }
  }

  private Map<String, Object> values(RuicConfig config) {
    return written.check().values(config.raw());
  }

  private static List<String> ids(List<ComponentConfig> components) {
    return components.stream().map(ComponentConfig::id).toList();
  }

  private static Map<String, String> connections(RuicConfig config) {
    Map<String, String> named = new TreeMap<>();
    for (ConnectionConfig c : config.connections()) {
      named.put(c.port().toString(), c.peers().toString());
    }
    return named;
  }
}
