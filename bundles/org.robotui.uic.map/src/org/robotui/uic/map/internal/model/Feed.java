package org.robotui.uic.map.internal.model;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.scene.Entity;
import org.robotui.ui.scene.Layer;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Scene;
import org.robotui.uic.map.internal.Kind;

/**
 * One input of the map: gives each source a layer of its own, prepares its entity from the newest value, and says what
 * is wrong. Worker thread, but for {@link #detail}.
 *
 * @param <T> the type of the data
 * @param <E> the entity that draws it
 */
public final class Feed<T extends Data, E extends Entity> {
  /** As long as a missing transform is not taken for more than a hiccup. */
  private static final long PATIENCE_NANOS = 1_000_000_000L;
  /** As many sources of the same trouble have a line each. */
  private static final int MOST_APART = 2;

  /** Makes an entity. */
  @FunctionalInterface
  public interface Maker<E extends Entity> {
    /** Makes that of a source, the n-th of its kind. */
    E make(int number, SourceId source);
  }

  /** Prepares an entity. */
  @FunctionalInterface
  public interface Preparer<T extends Data, E extends Entity> {
    /** Prepares; answers why it could not. */
    Optional<String> prepare(E entity, Envelope<T> newest, TickContext tick);
  }

  private static final class Source<T extends Data, E extends Entity> {
    final E entity;
    final Layer layer;
    Optional<Envelope<T>> shown = Optional.empty();
    Optional<FrameId> fixed = Optional.empty();
    Optional<String> problem = Optional.empty();
    Object dependence = "";
    long placedNanos;
    boolean placed;

    Source(E entity, Layer layer) {
      this.entity = entity;
      this.layer = layer;
    }
  }

  private enum Trouble {
    FAILED("failed"), WAITING("wait for data"), REFUSED("sent what was refused"), UNPLACED("without a transform"),
    STALE("stale");

    final String words;

    Trouble(String words) {
      this.words = words;
    }
  }

  private final Kind kind;
  private final Input<T> input;
  private final Scene scene;
  private final Maker<E> maker;
  private final Preparer<T, E> preparer;
  private final BiFunction<T, TickContext, Object> dependence;
  private final Map<SourceId, Source<T, E>> sources = new LinkedHashMap<>();
  private volatile Map<String, Envelope<T>> newest = Map.of();

  /**
   * An input.
   *
   * @param kind of its layers
   * @param input where data come from
   * @param scene where layers go
   * @param maker makes the entity of a source
   * @param preparer prepares it
   * @param dependence what else the entity depends on: it is prepared anew when this changes
   */
  public Feed(
      Kind kind,
      Input<T> input,
      Scene scene,
      Maker<E> maker,
      Preparer<T, E> preparer,
      BiFunction<T, TickContext, Object> dependence) {
    this.kind = kind;
    this.input = input;
    this.scene = scene;
    this.maker = maker;
    this.preparer = preparer;
    this.dependence = dependence;
  }

  /** Prepares what is new. */
  public boolean tick(TickContext tick) {
    List<SourceId> connected = input.sources();
    boolean changed = removeOthers(connected);
    for (SourceId id : connected) {
      changed |= tick(id, tick);
    }
    return changed;
  }

  /** The newest value of each source, in the order of the sources. */
  public List<Envelope<T>> values() {
    return input.sources().stream().flatMap(id -> input.latest(id).stream()).toList();
  }

  /**
   * What users should know of its sources, those of the same trouble in one line; nothing of those that are well or
   * hidden.
   */
  public List<Note> notes(TickContext tick) {
    Map<Trouble, List<Note>> notes = new EnumMap<>(Trouble.class);
    sources.forEach((id, source) -> {
      if (tick.options().shows(kind, source.layer.id())) {
        trouble(id, source).ifPresent(t -> notes.computeIfAbsent(t, n -> new ArrayList<>()).add(note(id, source, t)));
      }
    });
    return notes.entrySet().stream().flatMap(e -> e.getValue().size() <= MOST_APART ? e.getValue().stream()
        : Stream.of(together(e.getKey(), e.getValue()))).toList();
  }

  private Note together(Trouble trouble, List<Note> notes) {
    String first = trouble == Trouble.STALE ? "" : ", for example " + notes.getFirst().text();
    return new Note(notes.getFirst().health(),
        kind.data() + ": " + notes.size() + " of " + sources.size() + " " + trouble.words + first);
  }

  /** Where a layer's data come from and how old they are; any thread. */
  public Optional<String> detail(String layer, long nowNanos) {
    return Optional.ofNullable(newest.get(layer)).map(e -> e.source() + "  \u00b7  "
        + Figures.age(Math.max(0, e.ageSeconds(nowNanos))) + " ago");
  }

  /** The states of its sources, or of the input where it has none. */
  public List<InputState> states() {
    List<SourceId> connected = input.sources();
    return connected.isEmpty() ? List.of(input.state()) : connected.stream().map(input::state).toList();
  }

  private boolean removeOthers(List<SourceId> connected) {
    Set<SourceId> gone = new HashSet<>(sources.keySet());
    connected.forEach(gone::remove);
    gone.forEach(id -> forget(sources.remove(id).layer.id()));
    return !gone.isEmpty();
  }

  private boolean tick(SourceId id, TickContext tick) {
    Source<T, E> source = sources.get(id);
    if (source == null) {
      source = add(id);
    }
    boolean faded = input.state(id) instanceof InputState.Stale;
    boolean changed = source.layer.faded() != faded;
    source.layer.fade(faded);
    Optional<Envelope<T>> latest = input.latest(id);
    if (latest.isPresent() && due(source, latest.get(), tick)) {
      prepare(source, latest.get(), tick);
      changed = true;
    }
    boolean visible = tick.options().shows(kind, source.layer.id()) && trusted(source, tick.nowNanos());
    changed |= source.layer.visible() != visible;
    source.layer.show(visible);
    return changed;
  }

  private Source<T, E> add(SourceId id) {
    E entity = maker.make(sources.size(), id);
    Layer layer = new Layer(kind.word() + ":" + id, kind.ordinal(), kind.label() + "  \u00b7  " + id, entity);
    layer.show(false);
    Source<T, E> source = new Source<>(entity, layer);
    sources.put(id, source);
    scene.add(layer);
    return source;
  }

  private boolean due(Source<T, E> source, Envelope<T> latest, TickContext tick) {
    Object before = source.dependence;
    source.dependence = dependence.apply(latest.value(), tick);
    return !before.equals(source.dependence)
        || source.problem.isPresent()
        || source.shown.isEmpty()
        || source.shown.get() != latest && source.shown.get().value() != latest.value()
        || !source.fixed.equals(tick.placer().map(Placer::fixed));
  }

  private void prepare(Source<T, E> source, Envelope<T> latest, TickContext tick) {
    Optional<FrameId> fixed = tick.placer().map(Placer::fixed);
    if (!source.fixed.equals(fixed)) {
      source.fixed = fixed;
      source.placed = false;
    }
    source.shown = Optional.of(latest);
    remember(source.layer.id(), latest);
    source.problem = fixed.isEmpty()
        ? Optional.of("no frame is known")
        : preparer.prepare(source.entity, latest, tick);
    if (source.problem.isEmpty()) {
      source.placed = true;
      source.placedNanos = tick.nowNanos();
    }
  }

  private boolean trusted(Source<T, E> source, long nowNanos) {
    return source.placed && (source.problem.isEmpty() || nowNanos - source.placedNanos < PATIENCE_NANOS);
  }

  private Optional<Trouble> trouble(SourceId id, Source<T, E> source) {
    return switch (input.state(id)) {
      case InputState.Failed f -> Optional.of(Trouble.FAILED);
      case InputState.Waiting w -> Optional.of(Trouble.WAITING);
      case InputState.Stale s when s.refused() -> Optional.of(Trouble.REFUSED);
      case InputState state when source.problem.isPresent() -> Optional.of(Trouble.UNPLACED);
      case InputState.Stale s -> Optional.of(Trouble.STALE);
      default -> Optional.empty();
    };
  }

  private Note note(SourceId id, Source<T, E> source, Trouble trouble) {
    String name = kind.data() + (sources.size() > 1 ? " " + name(id) : "");
    InputState state = input.state(id);
    return switch (trouble) {
      case FAILED, WAITING -> new Note(StateView.health(state), name + ": " + state.explanation());
      case REFUSED -> new Note(Health.WARNING, name + ": " + state.explanation());
      case UNPLACED -> new Note(Health.WARNING, name + ": " + source.problem.orElse(""));
      case STALE -> new Note(Health.STALE,
          name + " " + (state instanceof InputState.Stale old ? StateView.sentence(old) : StateView.word(state)));
    };
  }

  /** Ports of several robot interfaces may have the same name. */
  private String name(SourceId id) {
    return sources.keySet().stream().map(SourceId::component).distinct().count() > 1 ? id.toString() : id.port();
  }

  private void forget(String layer) {
    scene.remove(layer);
    Map<String, Envelope<T>> others = new LinkedHashMap<>(newest);
    others.remove(layer);
    newest = Map.copyOf(others);
  }

  private void remember(String layer, Envelope<T> latest) {
    Map<String, Envelope<T>> all = new LinkedHashMap<>(newest);
    all.put(layer, latest);
    newest = Map.copyOf(all);
  }
}
