package org.robotui.script.internal.action;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.api.script.ActionWatch;
import org.robotui.api.script.ScriptLine;
import org.robotui.script.internal.action.SeenRuic.Hold;

/** What users do with robot UIs: views, perspectives, control, stops, selections, and taking one away. */
final class HostWatch implements ActionWatch {
  private final Host host;
  private Map<String, SeenRuic> before;
  /** Two robot UIs may have the same robot, whose stop is said once. */
  private final List<String> said = new ArrayList<>();

  HostWatch(Host host) {
    this.host = host;
    this.before = seen();
  }

  private Map<String, SeenRuic> seen() {
    Map<String, SeenRuic> all = new LinkedHashMap<>();
    for (Ruic ruic : host.ruics()) {
      all.put(ruic.name(), SeenRuic.of(ruic));
    }
    return all;
  }

  @Override
  public List<String> next() {
    Map<String, SeenRuic> now = seen();
    Map<String, SeenRuic> then = new HashMap<>(before);
    before = now;
    said.clear();
    then.keySet().stream().filter(name -> !now.containsKey(name)).sorted()
        .forEach(name -> say(ScriptLine.call("remove", name)));
    now.forEach((name, ruic) -> Optional.ofNullable(then.get(name)).ifPresent(old -> changes(name, old, ruic)));
    return List.copyOf(said);
  }

  private void say(String line) {
    if (!said.contains(line)) {
      said.add(line);
    }
  }

  private void changes(String name, SeenRuic old, SeenRuic now) {
    if (now.perspective().isPresent() && !now.perspective().equals(old.perspective())) {
      say(ScriptLine.call("perspective", now.perspective().get(), name));
    } else {
      views(name, old, now);
    }
    if (!now.selected().equals(old.selected())) {
      say(ScriptLine.call("selectRobots", now.selected(), name));
    }
    robots(old, now);
  }

  private void views(String name, SeenRuic old, SeenRuic now) {
    List<String> were = old.views().views();
    List<String> are = now.views().views();
    were.stream().filter(v -> !are.contains(v)).forEach(v -> say(ScriptLine.call("closeView", v, name)));
    are.stream().filter(v -> !were.contains(v))
        .forEach(v -> say(ScriptLine.call("openView", now.addedType(v).orElse(v), name)));
    List<String> fronted = are.stream()
        .filter(v -> were.contains(v) && now.isInFront(v) && !old.isInFront(v)).toList();
    boolean tabsAlone = now.views().liesAs(old.views());
    if (tabsAlone) {
      fronted.forEach(v -> say(ScriptLine.call("showView", v, name)));
    } else if (were.size() == are.size() && were.containsAll(are)) {
      say("// The views of " + ScriptLine.literal(name)
          + " were arranged by hand: keep that as a perspective, and choose it here.");
    }
  }

  private void robots(SeenRuic old, SeenRuic now) {
    now.begun(old, Hold::control).forEach(robot -> say(ScriptLine.call("takeControl", robot)));
    old.begun(now, Hold::control).forEach(robot -> say(ScriptLine.call("giveBackControl", robot)));
    now.begun(old, Hold::stopped).forEach(robot -> say(ScriptLine.call("stop", robot)));
    old.begun(now, Hold::stopped).forEach(robot -> say(ScriptLine.call("releaseStop", robot)));
  }
}
