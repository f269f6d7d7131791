package org.robotui.ui.layer;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.ui.ColorBar;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.KindSettings;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.display.SourceName;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Scene;

/** One layer while its view runs: made when it is listed and its kind is there, ended when not. Worker thread. */
final class LayerSlot {
  /** As long as a missing transform is not taken for more than a hiccup. */
  private static final long PATIENCE_NANOS = 1_000_000_000L;
  private static final LayerStatus NOTHING = new LayerStatus.NoData("");

  private final Scene scene;
  private final Map<SourceId, Envelope<? extends Data>> last = new HashMap<>();
  private DisplaySpec spec;
  private Optional<LayerType> type = Optional.empty();
  private Optional<Running> running = Optional.empty();
  private Optional<KindSettings> settings = Optional.empty();
  private SourceChoice choice = SourceChoice.NONE;
  private Set<SourceId> also = Set.of();
  private List<String> choices = List.of();
  private Optional<String> called = Optional.empty();
  private Optional<Envelope<? extends Data>> newest = Optional.empty();
  private InputState state = new InputState.Live(0, 0);
  private LayerStatus status = NOTHING;
  private Optional<Long> placedNanos = Optional.empty();

  /** What a layer is made of and still runs on; another kind object is another bundle. */
  private record Running(LayerType type, FencedLayer fenced, Layer layer) {}

  LayerSlot(Scene scene, DisplaySpec spec) {
    this.scene = scene;
    this.spec = spec;
  }

  DisplaySpec spec() {
    return spec;
  }

  Optional<LayerType> type() {
    return type;
  }

  SourceChoice choice() {
    return choice;
  }

  /** All streams that it takes. */
  Set<SourceId> taken() {
    Set<SourceId> all = new LinkedHashSet<>(choice.sources());
    all.addAll(also);
    return all;
  }

  /** What its colours mean, while it is seen. */
  Optional<ColorBar> colors() {
    return wanted() ? running.flatMap(r -> r.fenced().colors()) : Optional.empty();
  }

  InputState state() {
    return state;
  }

  LayerStatus status() {
    return status;
  }

  Optional<Envelope<? extends Data>> newest() {
    return newest;
  }

  /** Takes what the settings and the bundles say now. */
  void configure(DisplaySpec next, Optional<LayerType> kind, List<Input.Candidate> offered) {
    if (!same(kind) || !spec.shown() && next.shown() && failed().isPresent()) {
      end();
    }
    if (settings.isEmpty() || !next.settings().equals(spec.settings()) || kind.orElse(null) != type.orElse(null)) {
      settings = kind.map(k -> KindSettings.check(k.schema(), next.settings()));
    }
    spec = next;
    type = kind;
    choice = kind.map(k -> SourceChoice.of(next, LayerStack.kind(k), offered)).orElse(SourceChoice.NONE);
    also = kind.map(k -> k.also(settings.orElseThrow().settings())).orElse(Set.of());
    last.keySet().retainAll(taken());
    choices = kind
        .map(k -> k.accepts().stream().flatMap(a -> SourceChoice.fitting(a, offered).stream()).map(SourceName::of)
            .distinct().toList())
        .orElse(List.of());
  }

  private boolean same(Optional<LayerType> kind) {
    return running.isEmpty() || running.get().type() == kind.orElse(null);
  }

  /** Whether it is asked for data. */
  boolean wanted() {
    return spec.shown() && type.isPresent() && failed().isEmpty();
  }

  /** Prepares it; true where something else is to be seen. */
  boolean update(LayerInputs inputs, LayerContext context, LayerTick plain, int order) {
    if (type.isEmpty()) {
      return false;
    }
    Running on = running(context, order);
    boolean changed = false;
    if (wanted()) {
      state = choice.state(inputs.sources(), inputs::state);
      LayerResult result = on.fenced().update(tick(plain, arrived(inputs)));
      status = result.status();
      changed = result.changed();
    }
    if (!(status instanceof LayerStatus.NoFrame) && !(status instanceof LayerStatus.NoData)) {
      placedNanos = Optional.of(plain.nowNanos());
    }
    boolean stale = state instanceof InputState.Stale;
    boolean visible = wanted() && placedNanos.filter(at -> plain.nowNanos() - at < PATIENCE_NANOS).isPresent();
    changed |= on.layer().faded() != stale || on.layer().visible() != visible;
    on.layer().fade(stale);
    on.layer().show(visible);
    return changed;
  }

  private LayerTick tick(LayerTick plain, List<Envelope<? extends Data>> arrived) {
    LayerEntry entry = plain.entry();
    return new LayerTick(arrived, state, plain.placer(), plain.origin(), plain.robots(),
        new LayerEntry(name(), entry.number(), entry.count(), entry.ink(), entry.settings()), plain.nowNanos(),
        plain.reset());
  }

  /** Its settings, checked. */
  KindSettings settings() {
    return settings.orElseThrow();
  }

  private List<Envelope<? extends Data>> arrived(LayerInputs inputs) {
    List<Envelope<? extends Data>> all = new ArrayList<>();
    for (SourceId source : taken()) {
      List<Envelope<? extends Data>> came = inputs.arrived(source, Optional.ofNullable(last.get(source)));
      if (!came.isEmpty()) {
        last.put(source, came.getLast());
        all.addAll(came);
      }
    }
    all.stream().filter(e -> choice.sources().contains(e.source()))
        .reduce((a, b) -> b.receivedNanos() - a.receivedNanos() >= 0 ? b : a)
        .ifPresent(e -> newest = Optional.of(e));
    return all;
  }

  private Running running(LayerContext context, int order) {
    if (running.filter(r -> r.layer().order() == order && r.layer().caption().equals(caption())).isEmpty()) {
      Optional<Running> before = running;
      FencedLayer fenced = before.map(Running::fenced).orElseGet(() -> FencedLayer.of(type.orElseThrow(), context));
      Layer layer = new Layer(spec.id(), order, caption(), fenced);
      layer.show(before.filter(b -> b.layer().visible()).isPresent());
      layer.fade(before.filter(b -> b.layer().faded()).isPresent());
      scene.put(layer);
      running = Optional.of(new Running(type.orElseThrow(), fenced, layer));
    }
    return running.get();
  }

  void end() {
    running.ifPresent(r -> scene.remove(spec.id()));
    running = Optional.empty();
    last.clear();
    newest = Optional.empty();
    placedNanos = Optional.empty();
    status = NOTHING;
  }

  Optional<String> failed() {
    return running.flatMap(r -> r.fenced().fault());
  }

  String name() {
    return spec.name().isEmpty() ? called.or(() -> type.map(LayerType::label)).orElse(spec.type()) : spec.name();
  }

  /** Takes what it is called where the list has no name for it. */
  void name(Optional<String> wanted) {
    called = wanted;
  }

  private String caption() {
    return choice.sources().isEmpty() ? name()
        : type.map(LayerType::label).orElse("") + "  \u00b7  " + choice.sources().iterator().next();
  }

  DisplayRow row() {
    return new DisplayRow(spec, name(), health(), words(), 0, 0, settings.map(KindSettings::settings), choices);
  }

  private Health health() {
    if (type.isEmpty()) {
      return spec.shown() ? Health.WAITING : Health.NONE;
    }
    if (failed().isPresent()) {
      return Health.BAD;
    }
    if (!spec.shown()) {
      return Health.NONE;
    }
    if (!(state instanceof InputState.Live)) {
      return StateView.health(state);
    }
    return switch (status) {
      case LayerStatus.Shown s -> settings().problems().isEmpty() ? Health.OK : Health.WARNING;
      case LayerStatus.Partly p -> Health.WARNING;
      case LayerStatus.NoData n -> Health.WAITING;
      case LayerStatus.NoFrame n -> Health.WARNING;
      case LayerStatus.Unfit u -> Health.BAD;
    };
  }

  private String words() {
    if (type.isEmpty()) {
      return "waits for a bundle that brings layers of type '" + spec.type() + "'";
    }
    if (failed().isPresent()) {
      return "failed and was switched off: " + failed().get() + "; switch it off and on to try again";
    }
    if (!spec.shown()) {
      return "switched off";
    }
    if (!settings().problems().isEmpty()) {
      return settings().problems().getFirst();
    }
    return switch (state) {
      case InputState.Live l -> status.words();
      case InputState.Stale old -> StateView.sentence(old);
      case InputState other -> other.explanation();
    };
  }
}
