package org.robotui.core.internal.compose;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.RuicDraft;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.LayoutChange;

/**
 * A RUIC as lines of a configuration: no more than its type does not say already.
 *
 * @param draft what the user wants
 * @param type of the RUIC
 * @param robot the robot interface
 * @param schema what that can be configured with
 */
record RuicText(RuicDraft draft, RuicType type, InterfaceConfig robot, Schema schema) {
  private static final int WIDTH = 120;

  /** The lines, the name without indentation. */
  List<String> lines() {
    List<String> brought = RuicFits.layout(type).views();
    Optional<Setting> single =
        brought.size() == 1 && draft.views().size() == 1 ? viewSetting(brought.getFirst()) : Optional.empty();
    List<String> lines =
        new ArrayList<>(List.of(YamlWords.text(draft.name()) + ":", "  type: " + YamlWords.text(type.id())));
    lines.add("  rfics:");
    lines.addAll(rfic());
    if (single.isPresent()) {
      lines.addAll(2, settingOf(single.get()));
    } else {
      lines.addAll(views(brought));
    }
    if (!draft.connections().isEmpty()) {
      lines.add("  connect:");
      draft.connections().forEach(
          (port, peer) -> lines.add("    " + YamlWords.text(port.toString()) + ": " + YamlWords.text(peer.toString())));
    }
    return lines;
  }

  private List<String> settingOf(Setting single) {
    boolean usual = single.fallback().filter(draft.views().getFirst()::equals).isPresent();
    return usual ? List.of() : List.of("  " + single.name() + ": " + YamlWords.text(draft.views().getFirst()));
  }

  /** The setting by which a type takes the one view that it brings. */
  private Optional<Setting> viewSetting(String brought) {
    return type.schema().settings().stream()
        .filter(s -> s.type() instanceof ValueType.Text && s.fallback().filter(brought::equals).isPresent())
        .findFirst();
  }

  /** In one line where that can be read, else a line for each setting. */
  private List<String> rfic() {
    List<String> words = new ArrayList<>(List.of("type: " + YamlWords.text(robot.type())));
    if (!robot.robot().isBlank() && !robot.robot().equals(draft.name())) {
      words.add("robot: " + YamlWords.text(robot.robot()));
    }
    robot.settings().forEach((name, value) -> words.add(setting(name, value)));
    String one = "    " + robot.id() + ": {" + String.join(", ", words) + "}";
    if (one.length() <= WIDTH) {
      return List.of(one);
    }
    List<String> lines = new ArrayList<>(List.of("    " + robot.id() + ":"));
    words.forEach(w -> lines.add("      " + w));
    return lines;
  }

  private String setting(String name, Object value) {
    ValueType setting = schema.find(name).map(Setting::type).orElse(new ValueType.Text());
    return YamlWords.text(name) + ": " + YamlWords.value(value, setting);
  }

  private List<String> views(List<String> brought) {
    Set<String> wanted = new HashSet<>(draft.views());
    List<String> without = brought.stream().filter(id -> !wanted.contains(id)).toList();
    List<String> more = draft.views().stream().filter(id -> !brought.contains(id)).toList();
    List<String> lines = new ArrayList<>();
    if (!without.isEmpty()) {
      lines.addAll(list("without", without));
    }
    if (!more.isEmpty()) {
      lines.add("  uics:");
      more.forEach(id -> lines.add("    " + YamlWords.text(id) + ": {}"));
      lines.add("  layout:");
      layout(with(LayoutChange.without(RuicFits.layout(type), without), more), 4, lines);
    }
    return lines;
  }

  private static List<String> list(String word, List<String> ids) {
    List<String> texts = ids.stream().map(YamlWords::text).toList();
    String one = "  " + word + ": [" + String.join(", ", texts) + "]";
    if (one.length() <= WIDTH) {
      return List.of(one);
    }
    List<String> lines = new ArrayList<>(List.of("  " + word + ":"));
    texts.forEach(t -> lines.add("    - " + t));
    return lines;
  }

  /** Views that the type does not bring lie in tabs behind the first. */
  private static Layout with(Layout layout, List<String> more) {
    return switch (layout) {
      case Layout.View v -> new Layout.Tabs(joined(List.of(v.uic()), more));
      case Layout.Tabs t -> new Layout.Tabs(joined(t.uics(), more));
      case Layout.Split s -> {
        List<Layout> parts = new ArrayList<>(s.parts());
        parts.set(0, with(parts.getFirst(), more));
        yield new Layout.Split(s.direction(), parts, s.weights());
      }
    };
  }

  private static List<String> joined(List<String> first, List<String> then) {
    List<String> all = new ArrayList<>(first);
    all.addAll(then);
    return all;
  }

  private static void layout(Layout layout, int indent, List<String> lines) {
    String before = " ".repeat(indent);
    switch (layout) {
      case Layout.View v -> lines.add(before + "view: " + YamlWords.text(v.uic()));
      case Layout.Tabs t -> lines.add(before + "tabs: " + tabs(t));
      case Layout.Split s -> {
        lines.add(before + s.direction().name().toLowerCase(Locale.ROOT) + ":");
        for (int i = 0; i < s.parts().size(); i++) {
          lines.add(before + "  - weight: " + weight(s.weights().get(i)));
          layout(s.parts().get(i), indent + 4, lines);
        }
      }
    }
  }

  private static String tabs(Layout.Tabs tabs) {
    return tabs.uics().stream().map(YamlWords::text).collect(Collectors.joining(", ", "[", "]"));
  }

  private static String weight(double weight) {
    return weight == Math.rint(weight) ? Long.toString(Math.round(weight)) : Double.toString(weight);
  }
}
