package org.robotui.core.internal.life;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.RuicType;
import org.robotui.api.RuicType.UicSpec;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.LayoutChange;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.SettingsCheck;

/**
 * Which views a RUIC has, and where: those of its type, configured and joined by those that the file names.
 *
 * @param type its type, where it has one
 * @param uics its views
 * @param layout where they lie
 */
public record Plan(Optional<RuicType> type, List<ComponentConfig> uics, Layout layout) {
  /** A plan, or why there is none. */
  public sealed interface Outcome {
    /** A plan. */
    record Made(Plan plan) implements Outcome {}

    /** No plan. */
    record Impossible(String reason) implements Outcome {}
  }

  /** Plans with the types that are installed now. */
  public static Outcome of(RuicConfig config, Registry registry, SettingsCheck check) {
    if (config.type().isEmpty()) {
      Layout layout = config.layout().orElseGet(() -> tabs(config.uics()));
      return new Outcome.Made(new Plan(Optional.empty(), config.uics(), layout));
    }
    return registry.ruic(config.type())
        .map(type -> typed(config, type, check))
        .orElseGet(() -> new Outcome.Impossible(registry.missingRuic(config.type())));
  }

  private static Outcome typed(RuicConfig config, RuicType type, SettingsCheck check) {
    return switch (check.check(type.schema(), config.raw())) {
      case CheckedSettings.Valid v -> new Outcome.Made(made(config, type, v.settings(), check));
      case CheckedSettings.Invalid i -> new Outcome.Impossible(text(i.problems()));
    };
  }

  private static Plan made(RuicConfig config, RuicType type, Settings settings, SettingsCheck check) {
    Map<String, ComponentConfig> uics = new LinkedHashMap<>();
    type.uics(settings).stream().filter(spec -> !config.without().contains(spec.id()))
        .forEach(spec -> uics.put(spec.id(), brought(spec, config, check)));
    for (ComponentConfig written : config.uics()) {
      uics.merge(written.id(), written, (spec, own) -> own.type().isEmpty() ? own.withType(spec.type()) : own);
    }
    Layout layout = config.layout().orElseGet(() -> LayoutChange.without(type.layout(settings), config.without()));
    return new Plan(Optional.of(type), uics.values().stream().map(Plan::typed).toList(), layout);
  }

  /** A view without a type that the RUIC's type does not bring is named after its own. */
  private static ComponentConfig typed(ComponentConfig uic) {
    return uic.type().isEmpty() ? uic.withType(uic.id()) : uic;
  }

  private static ComponentConfig brought(UicSpec spec, RuicConfig config, SettingsCheck check) {
    return new ComponentConfig(
        spec.id(), spec.type(), "", "", check.nothing(), config.file(), config.line(), config.column());
  }

  private static Layout tabs(List<ComponentConfig> uics) {
    return new Layout.Tabs(uics.stream().map(ComponentConfig::id).toList());
  }

  /** Problems as a reason. */
  static String text(List<Problem> problems) {
    return problems.stream().map(Problem::toString).collect(Collectors.joining("; "));
  }
}
