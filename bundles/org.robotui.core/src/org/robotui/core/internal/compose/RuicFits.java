package org.robotui.core.internal.compose;

import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.host.RuicFit;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Layout;

/** Says of types of RUICs how well they cover what a robot offers. */
final class RuicFits {
  private RuicFits() {}

  /** The best first. A type that needs settings is left out: nobody has been asked for them. */
  static List<RuicFit> of(List<RuicType> types, List<ViewFit> views) {
    return types.stream().filter(t -> t.schema().settings().stream().noneMatch(Setting::required))
        .map(t -> of(t, views))
        .sorted(Comparator.comparingDouble(RuicFit::score).reversed().thenComparing(RuicFit::label)).toList();
  }

  private static RuicFit of(RuicType type, List<ViewFit> views) {
    List<String> brought = layout(type).views().stream().distinct().toList();
    Set<String> fitting = new HashSet<>();
    views.stream().filter(ViewFit::fits).map(ViewFit::type).forEach(fitting::add);
    long hits = brought.stream().filter(fitting::contains).count();
    // High where a type brings most of what fits, and little else; a single view that fits is not the best, nor is
    // everything.
    double score = brought.isEmpty() || fitting.isEmpty() ? 0 : 2.0 * hits / (brought.size() + fitting.size());
    long empty = brought.size() - hits;
    String reason = "brings " + hits + " of the " + fitting.size() + " views that fit"
        + (empty == 0 ? "" : "; " + empty + " of its views would stay empty");
    return new RuicFit(type.id(), type.label(), type.help(), brought, score, reason);
  }

  /** Where the views of a type lie, with nothing set. */
  static Layout layout(RuicType type) {
    return type.layout(usual(type.schema()));
  }

  private static Settings usual(Schema schema) {
    Map<String, Object> values = new HashMap<>();
    schema.settings().forEach(s -> s.fallback().ifPresent(f -> values.put(s.name(), f)));
    return new Settings(schema, values);
  }
}
