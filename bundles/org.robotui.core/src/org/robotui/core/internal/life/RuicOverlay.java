package org.robotui.core.internal.life;

import java.util.HashMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ChosenInterface;
import org.robotui.core.internal.config.model.KeptViews;
import org.robotui.core.internal.config.model.Overlay;
import org.robotui.core.internal.config.model.OverlayFile;

/**
 * What the user changed in one RUIC.
 *
 * @param store keeps it
 * @param ruic its name
 */
public record RuicOverlay(OverlayStore store, String ruic) {
  /** The settings of a view that were changed. */
  Map<String, Object> settings(String uic) {
    return store.get(ruic).settings().getOrDefault(uic, Map.of());
  }

  /** The connections that were chosen. */
  Map<SourceId, SourceId> connections() {
    return store.get(ruic).connections();
  }

  void set(String uic, String name, Object value) {
    store.change(ruic, old -> new Overlay(with(old.settings(), uic, with(settingsOf(old, uic), name, value)),
        old.connections(), old.interfaces(), old.views()));
  }

  void connect(SourceId port, SourceId peer) {
    store.change(ruic, old -> new Overlay(old.settings(), with(old.connections(), port, peer),
        old.interfaces(), old.views()));
  }

  /** The robot interfaces that took the place of written ones, by id. */
  Map<String, ChosenInterface> interfaces() {
    return store.get(ruic).interfaces();
  }

  void put(String id, ChosenInterface chosen) {
    store.change(ruic, old -> new Overlay(old.settings(), old.connections(),
        with(old.interfaces(), id, chosen), old.views()));
  }

  /** What is written holds again. */
  void forgetInterface(String id) {
    if (interfaces().containsKey(id)) {
      store.change(ruic, old -> {
        Map<String, ChosenInterface> others = new HashMap<>(old.interfaces());
        others.remove(id);
        return new Overlay(old.settings(), old.connections(), others, old.views());
      });
    }
  }

  /** How the views are arranged. */
  KeptViews views() {
    return store.get(ruic).views();
  }

  void arrange(UnaryOperator<KeptViews> change) {
    store.change(ruic, old -> new Overlay(old.settings(), old.connections(), old.interfaces(),
        change.apply(old.views())));
  }

  /** How perspectives are written for others, and read. */
  OverlayFile format() {
    return store.format();
  }

  private static Map<String, Object> settingsOf(Overlay overlay, String uic) {
    return overlay.settings().getOrDefault(uic, Map.of());
  }

  private static <K, V> Map<K, V> with(Map<K, V> map, K key, V value) {
    Map<K, V> changed = new HashMap<>(map);
    changed.put(key, value);
    return changed;
  }
}
