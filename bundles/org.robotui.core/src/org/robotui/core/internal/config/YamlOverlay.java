package org.robotui.core.internal.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.NamedFile;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.OverlayFile;
import org.robotui.core.internal.config.model.PerspectiveFile;
import org.yaml.snakeyaml.error.YAMLException;

/** Keeps what users changed as YAML, so that it can be read, shared and mended by hand. */
public final class YamlOverlay implements OverlayFile {
  private static final long MAX_BYTES = 4 << 20;

  @Override
  public Map<String, Overlay> read(Path file, Consumer<String> damage) throws IOException {
    if (!Files.exists(file)) {
      return Map.of();
    }
    try {
      Object root = KeptYaml.value(NamedFile.text(file, MAX_BYTES));
      Map<String, Overlay> overlays = new LinkedHashMap<>();
      KeptYaml.map(root).forEach(
          (name, value) -> overlay(name, value, damage).ifPresent(overlay -> overlays.put(name, overlay)));
      return overlays;
    } catch (YAMLException | ClassCastException | IllegalArgumentException e) {
      throw new IOException(file + " is not what was kept there: " + e.getMessage(), e);
    }
  }

  private static Optional<Overlay> overlay(String name, Object value, Consumer<String> damage) {
    try {
      return Optional.of(overlay(KeptYaml.map(value)));
    } catch (ClassCastException | IllegalArgumentException e) {
      damage.accept("what was kept of " + name + " cannot be understood: " + e.getMessage());
      return Optional.empty();
    }
  }

  @Override
  public void write(Path file, Map<String, Overlay> overlays) throws IOException {
    Map<String, Object> root = new TreeMap<>();
    overlays.forEach((name, overlay) -> root.put(name, written(overlay)));
    AtomicFile.writePrivate(file, KeptYaml.text(root));
  }

  @Override
  public String text(PerspectiveFile perspective) {
    return "# A perspective of RobotUI: where views lie, and what they are. Import it by View > Perspectives.\n"
        + KeptYaml.text(KeptViewsYaml.written(perspective));
  }

  @Override
  public PerspectiveFile perspective(String text) throws IOException {
    try {
      return KeptViewsYaml.perspective(KeptYaml.value(text));
    } catch (YAMLException | IllegalArgumentException e) {
      throw new IOException(e.getMessage(), e);
    }
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
    Map<String, Object> views = KeptViewsYaml.written(overlay.views());
    if (!views.isEmpty()) {
      written.put("views", views);
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
    KeptYaml.map(value.get("settings")).forEach((view, values) -> settings.put(view, KeptYaml.settings(values)));
    Map<SourceId, SourceId> connections = new LinkedHashMap<>();
    KeptYaml.map(value.get("connect"))
        .forEach((port, peer) -> connections.put(port(port), port(peer.toString())));
    Map<String, ChosenInterface> interfaces = new LinkedHashMap<>();
    KeptYaml.map(value.get("rfics")).forEach((id, chosen) -> interfaces.put(id, chosen(KeptYaml.map(chosen))));
    return new Overlay(settings, connections, interfaces, KeptViewsYaml.read(value.get("views")));
  }

  private static ChosenInterface chosen(Map<String, Object> value) {
    return new ChosenInterface(text(value, "type"), text(value, "robot"),
        KeptYaml.settings(value.get("settings")),
        text(value, "instead_of"));
  }

  private static String text(Map<String, Object> value, String key) {
    return value.getOrDefault(key, "").toString();
  }

  private static SourceId port(String text) {
    int dot = text.indexOf('.');
    return new SourceId(text.substring(0, Math.max(0, dot)), text.substring(dot + 1));
  }
}
