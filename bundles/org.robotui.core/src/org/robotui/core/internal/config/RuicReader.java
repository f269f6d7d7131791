package org.robotui.core.internal.config;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.robotui.api.RuicType;
import org.robotui.api.host.Problem;
import org.robotui.api.layout.Layout;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.ConnectionConfig;
import org.robotui.core.internal.config.model.FixedWords;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.config.model.TypeLookup;
import org.robotui.data.geometry.FrameTransform;

/** Reads one RUIC. */
final class RuicReader {
  private static final List<String> OWN =
      List.of("type", "start", "rfics", "frames", "without", "uics", "connect", "layout", "perspectives", "safety");

  private final TypeLookup types;
  private final List<Problem> problems;

  RuicReader(TypeLookup types, List<Problem> problems) {
    this.types = types;
    this.problems = problems;
  }

  Optional<RuicConfig> read(YamlValue.Entry entry) {
    return Shape.section(entry.value(), "the RUIC '" + entry.key() + "'", problems).map(s -> read(entry, s));
  }

  private RuicConfig read(YamlValue.Entry entry, YamlValue.Section section) {
    String name = entry.key();
    String type = section.get("type").flatMap(v -> Shape.text(v, "'type'", problems)).orElse("");
    WrittenSection raw = new WrittenSection(section.without(OWN));
    Brought ofType = broughtViews(section, type, raw);
    List<String> without = section.get("without").map(v -> without(v, ofType.views())).orElse(List.of());
    Brought brought = ofType.without(without);
    ComponentReader components = new ComponentReader(types, problems);
    List<ComponentConfig> rfics = components.rfics(part(section, "rfics"), name);
    List<ComponentConfig> uics = components.uics(part(section, "uics"), brought);
    uniqueIds(rfics, uics);
    Set<String> ids = new TreeSet<>(brought.types().keySet());
    uics.forEach(u -> ids.add(u.id()));
    Known views = new Known(ids, brought.all());
    needed(entry, type, rfics, ids);
    List<ConnectionConfig> connections =
        new ConnectionReader(views, Known.all(ids(rfics)), problems).read(part(section, "connect"));
    Optional<Layout> layout = section.get("layout").flatMap(new LayoutReader(views, problems)::readWhole);
    Map<String, Layout> perspectives = perspectives(part(section, "perspectives"), views);
    Map<String, SafetyConfig> safety = new SafetyReader(types, problems).read(part(section, "safety"), rfics);
    List<FrameTransform> frames = section.get("frames").map(new FramesReader(problems)::read).orElse(List.of());
    boolean startsShown = section.get("start").map(this::startsShown).orElse(false);
    Place at = entry.place();
    return new RuicConfig(name, at.file(), at.line(), at.column(), type, raw, rfics, without, uics, connections, layout,
        perspectives, safety, frames, startsShown);
  }

  private Map<String, Layout> perspectives(YamlValue.Section section, Known views) {
    Map<String, Layout> layouts = new LinkedHashMap<>();
    section.entries().forEach(entry -> new LayoutReader(views, problems).readWhole(entry.value())
        .ifPresent(layout -> layouts.put(entry.key(), layout)));
    return layouts;
  }

  private List<String> without(YamlValue value, Known ofType) {
    List<String> left = new ArrayList<>();
    for (YamlValue item : Shape.items(value)) {
      Shape.text(item, "'without'", "the id of a view of the type", problems).ifPresent(id -> {
        left.add(id);
        if (!ofType.mayHave(id)) {
          problems.add(item.place().error(
              "the type brings no view '" + id + "' that could be left out" + NearestWord.hint(id, ofType.ids())));
        }
      });
    }
    return left;
  }

  private boolean startsShown(YamlValue value) {
    String word = Shape.text(value, "'start'", problems).orElse(FixedWords.STARTS.getFirst());
    if (!FixedWords.STARTS.contains(word)) {
      problems.add(value.place()
          .error("'start' must be one of " + String.join(", ", FixedWords.STARTS) + ", not '" + word + "'"));
    }
    return FixedWords.STARTS.getLast().equals(word);
  }

  private YamlValue.Section part(YamlValue.Section section, String key) {
    return section.get(key)
        .flatMap(v -> Shape.section(v, "'" + key + "'", problems))
        .orElse(new YamlValue.Section(List.of(), section.place()));
  }

  /** The views that the RUIC's type brings along; checks the settings of the type on the way. */
  private Brought broughtViews(YamlValue.Section section, String type, WrittenSection raw) {
    Optional<RuicType> found = types.ruic(type);
    if (found.isEmpty()) {
      unknownType(section, type);
      return new Brought(Map.of(), type.isEmpty());
    }
    return switch (new SchemaCheck().check(found.get().schema(), raw)) {
      case CheckedSettings.Valid v -> Brought.of(found.get().uics(v.settings()));
      case CheckedSettings.Invalid i -> {
        i.problems().forEach(p -> problems.add(withOwnWords(p)));
        yield new Brought(Map.of(), false);
      }
    };
  }

  /** A slip in a word of the RUIC itself looks like an unknown setting of its type: say the nearer word. */
  private static Problem withOwnWords(Problem problem) {
    String prefix = "unknown setting '";
    if (!problem.message().startsWith(prefix)) {
      return problem;
    }
    String word = problem.message().substring(prefix.length(), problem.message().indexOf('\'', prefix.length()));
    return NearestWord.of(word, OWN)
        .map(near -> new Problem(problem.file(), problem.line(), problem.column(), problem.severity(),
            "unknown word '" + word + "' in a RUIC; did you mean '" + near + "'?" + Repeated.behind(problem.message())))
        .orElse(problem);
  }

  private void unknownType(YamlValue.Section section, String type) {
    if (type.isEmpty()) {
      Shape.onlyKeys(section, OWN, "in a RUIC without a type", problems);
    } else {
      Place at = section.get("type").map(YamlValue::place).orElse(section.place());
      problems.add(at.warning("no RUIC type '" + type + "' is installed" + NearestWord.hint(type, types.ruicIds())));
      section.without(OWN).entries().forEach(this::slip);
    }
  }

  /** What the missing type can be told is not known; a word next to one of ours is a slip all the same. */
  private void slip(YamlValue.Entry entry) {
    NearestWord.of(entry.key(), OWN).ifPresent(near -> problems.add(entry.place().warning(
        "'" + entry.key() + "' is no word of a RUIC; did you mean '" + near + "'?")));
  }

  private void uniqueIds(List<ComponentConfig> rfics, List<ComponentConfig> uics) {
    Set<String> taken = Set.copyOf(ids(rfics));
    uics.stream().filter(u -> taken.contains(u.id())).forEach(u -> problems.add(
        new Place(u.file(), u.line(), u.column())
            .error("'" + u.id() + "' names a robot interface already; choose another")));
  }

  private void needed(YamlValue.Entry entry, String type, List<ComponentConfig> rfics, Set<String> views) {
    if (rfics.isEmpty()) {
      problems
          .add(entry.place().error("'" + entry.key() + "' has no robot interface; write rfics: {base: {type: ros}}"));
    }
    if (type.isEmpty() && views.isEmpty()) {
      problems.add(entry.place().error(
          "'" + entry.key() + "' has nothing to show; write type: " + String.join(" or ", types.ruicIds())
              + ", or uics:"));
    }
  }

  private static List<String> ids(List<ComponentConfig> components) {
    return components.stream().map(ComponentConfig::id).toList();
  }
}
