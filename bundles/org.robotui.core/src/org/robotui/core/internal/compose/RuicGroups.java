package org.robotui.core.internal.compose;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.ComponentType;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.SettingsGroup;
import org.robotui.api.host.SettingsGroup.Part;
import org.robotui.api.port.Port;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.FixedWords;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.SettingsCheck;
import org.robotui.core.internal.config.model.WrittenText;
import org.robotui.core.internal.life.Plan;
import org.robotui.core.internal.life.Registry;

/**
 * What a file can say of its RUICs.
 *
 * @param registry the types
 * @param check reads values
 * @param written what the file says
 * @param file the file
 * @param reading tells its text apart from a later one
 * @param ports that are there
 */
record RuicGroups(Registry registry, SettingsCheck check, WrittenText written, Path file, String reading,
    PortChoices ports) {
  private static final ValueType PEERS =
      new ValueType.AnyOf(List.of(new ValueType.Text(), new ValueType.ListOf(new ValueType.Text())));
  private static final String BRIDGES = "bridges";
  private static final Set<String> ENDS = Set.of("from", "to");
  private static final String PEER_HELP =
      "a port of an interface, such as base.scan, several with commas, or none; without it matching decides";

  Stream<SettingsGroup> of(RuicConfig ruic) {
    List<SettingsGroup> groups = new ArrayList<>();
    groups.add(group(ruic, Part.RUIC, "", ruic.name(), ruic.type(),
        schema(FixedWords.RUIC, registry.ruic(ruic.type())), List.of()));
    ruic.rfics().forEach(c -> groups.add(group(ruic, Part.INTERFACE, c.id(), c.title(), c.type(),
        schema(FixedWords.INTERFACE, registry.rfic(c.type())), List.of("rfics", c.id()))));
    List<ComponentConfig> views = views(ruic);
    views.forEach(c -> groups.add(group(ruic, Part.VIEW, c.id(), viewTitle(c), c.type(),
        schema(FixedWords.VIEW, registry.uic(c.type())), List.of("uics", c.id()))));
    groups.add(group(ruic, Part.CONNECTIONS, "", "Connections", "", connections(ruic, views), List.of("connect")));
    ruic.rfics().stream().map(ComponentConfig::robot).distinct().forEach(robot -> groups.add(
        group(ruic, Part.SAFETY, robot, robot, "", FixedWords.SAFETY, List.of("safety", robot))));
    return groups.stream();
  }

  /** What the file can say of itself. */
  SettingsGroup bridges() {
    ValueType bridge = new ValueType.Section(ports.ends(BridgeWords.SCHEMA, ENDS));
    Schema schema = Schema.of(Setting.optional(BRIDGES, new ValueType.MapOf(bridge),
        "what one robot says, carried to the software of another one, by a name of your choice"));
    return group(Part.BRIDGES, "", "", "Bridges", "", schema, List.of());
  }

  private List<ComponentConfig> views(RuicConfig ruic) {
    return Plan.of(ruic, registry, check) instanceof Plan.Outcome.Made made ? made.plan().uics() : ruic.uics();
  }

  private String viewTitle(ComponentConfig view) {
    return view.title().isEmpty() ? registry.uic(view.type()).map(ComponentType::label).orElse(view.id())
        : view.title();
  }

  private static Schema schema(Schema fixed, Optional<? extends ComponentType> type) {
    return new Schema(Stream.concat(fixed.settings().stream(),
        type.map(t -> t.choices().settings()).orElse(List.of()).stream()).toList());
  }

  /** The ports of all views, and what is written beside them: some ports are there only while a view runs. */
  private Schema connections(RuicConfig ruic, List<ComponentConfig> views) {
    Map<String, Setting> settings = new LinkedHashMap<>();
    ValueType peers = PortChoices.among(ports.of(ruic.name()), PEERS);
    for (ComponentConfig view : views) {
      List<Port> ports = registry.uic(view.type()).map(ComponentType::ports).orElse(List.of());
      ports.forEach(port -> add(settings, view.id() + "." + port.name(), peers, port.typeName() + ": "));
    }
    ruic.connections().forEach(c -> add(settings, c.port().toString(), peers, ""));
    return new Schema(List.copyOf(settings.values()));
  }

  private static void add(Map<String, Setting> settings, String name, ValueType peers, String type) {
    settings.putIfAbsent(name, Setting.optional(name, peers, type + PEER_HELP));
  }

  private SettingsGroup group(RuicConfig ruic, Part part, String id, String title, String type, Schema schema,
      List<String> within) {
    return group(part, ruic.name(), id, title, type, schema,
        Stream.concat(Stream.of("ruics", ruic.name()), within.stream()).toList());
  }

  private SettingsGroup group(Part part, String ruic, String id, String title, String type, Schema schema,
      List<String> path) {
    Map<String, Object> all = written.at(path).map(check::values).orElse(Map.of());
    Map<String, Object> values = all.entrySet().stream().filter(e -> schema.find(e.getKey()).isPresent())
        .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue, (a, b) -> a, LinkedHashMap::new));
    return new SettingsGroup(part, ruic, id, title, type, file, path, written.line(path), schema, values,
        reading);
  }
}
