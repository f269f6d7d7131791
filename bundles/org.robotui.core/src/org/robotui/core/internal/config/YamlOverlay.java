package org.robotui.core.internal.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.OverlayFile;
import org.yaml.snakeyaml.DumperOptions;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.representer.Representer;

/** Keeps what users changed as YAML, so that it can be read, shared and mended by hand. */
public final class YamlOverlay implements OverlayFile {
  private static final long MAX_BYTES = 4 << 20;
  private static final int MAX_DEPTH = 20;

  @Override
  public Map<String, Overlay> read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return Map.of();
    }
    try {
      Object root = yaml().load(NamedFile.text(file, MAX_BYTES));
      bounded(root, 0);
      Map<String, Overlay> overlays = new LinkedHashMap<>();
      map(Optional.ofNullable(root).orElse(Map.of())).forEach((name, value) -> overlays.put(name, overlay(map(value))));
      return overlays;
    } catch (YAMLException | ClassCastException | IllegalArgumentException e) {
      throw new IOException(file + " is not what was kept there: " + e.getMessage(), e);
    }
  }

  /** An alias of something that it is part of would be followed for ever. */
  private static void bounded(Object value, int depth) {
    if (depth > MAX_DEPTH) {
      throw new YAMLException("it is nested too deeply");
    }
    switch (value) {
      case Map<?, ?> map -> map.values().forEach(v -> bounded(v, depth + 1));
      case List<?> list -> list.forEach(v -> bounded(v, depth + 1));
      case null, default -> {}
    }
  }

  @Override
  public void write(Path file, Map<String, Overlay> overlays) throws IOException {
    Map<String, Object> root = new TreeMap<>();
    overlays.forEach((name, overlay) -> root.put(name, written(overlay)));
    AtomicFile.writePrivate(file, yaml().dump(root));
  }

  private static Yaml yaml() {
    DumperOptions options = new DumperOptions();
    options.setDefaultFlowStyle(DumperOptions.FlowStyle.BLOCK);
    LoaderOptions limits = new LoaderOptions();
    return new Yaml(new SafeConstructor(limits), new Representer(options), options, limits);
  }

  private static Map<String, Object> written(Overlay overlay) {
    Map<String, String> connections = new TreeMap<>();
    overlay.connections().forEach((port, peer) -> connections.put(port.toString(), peer.toString()));
    Map<String, Object> written =
        new TreeMap<>(Map.of("settings", new TreeMap<>(overlay.settings()), "connect", connections));
    if (!overlay.interfaces().isEmpty()) {
      Map<String, Object> interfaces = new TreeMap<>();
      overlay.interfaces().forEach((id, chosen) -> interfaces.put(id, written(chosen)));
      written.put("rfics", interfaces);
    }
    return written;
  }

  private static Map<String, Object> written(ChosenInterface chosen) {
    Map<String, Object> written = new LinkedHashMap<>();
    written.put("type", chosen.type());
    written.put("robot", chosen.robot());
    written.put("settings", new LinkedHashMap<>(chosen.settings()));
    written.put("instead_of", chosen.insteadOf());
    return written;
  }

  private static Overlay overlay(Map<String, Object> value) {
    Map<String, Map<String, Object>> settings = new LinkedHashMap<>();
    map(value.getOrDefault("settings", Map.of())).forEach((view, values) -> settings.put(view, asKept(map(values))));
    Map<SourceId, SourceId> connections = new LinkedHashMap<>();
    map(value.getOrDefault("connect", Map.of()))
        .forEach((port, peer) -> connections.put(port(port), port(peer.toString())));
    Map<String, ChosenInterface> interfaces = new LinkedHashMap<>();
    map(value.getOrDefault("rfics", Map.of())).forEach((id, chosen) -> interfaces.put(id, chosen(map(chosen))));
    return new Overlay(settings, connections, interfaces);
  }

  private static ChosenInterface chosen(Map<String, Object> value) {
    return new ChosenInterface(text(value, "type"), text(value, "robot"),
        asKept(map(value.getOrDefault("settings", Map.of()))),
        text(value, "instead_of"));
  }

  private static String text(Map<String, Object> value, String key) {
    return value.getOrDefault(key, "").toString();
  }

  /** YAML reads small numbers as Integer; settings hold Long. */
  private static Map<String, Object> asKept(Map<String, Object> values) {
    Map<String, Object> kept = new LinkedHashMap<>();
    values.forEach((name, value) -> kept.put(name, value instanceof Integer i ? (Object) i.longValue() : value));
    return kept;
  }

  private static SourceId port(String text) {
    int dot = text.indexOf('.');
    return new SourceId(text.substring(0, Math.max(0, dot)), text.substring(dot + 1));
  }

  private static Map<String, Object> map(Object value) {
    Map<String, Object> copy = new LinkedHashMap<>();
    Map<?, ?> written = "".equals(value) ? Map.of() : (Map<?, ?>) value;
    written.forEach((k, v) -> copy.put(String.valueOf(k), v == null ? "" : v));
    return copy;
  }
}
