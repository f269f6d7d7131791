package org.robotui.ui.layer;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robotui.api.UicContext;
import org.robotui.api.config.Settings;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.api.replay.StreamHistory;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.ui.ColorBar;
import org.robotui.ui.Figures;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplayEntry;
import org.robotui.ui.display.DisplayKind;
import org.robotui.ui.display.DisplayList;
import org.robotui.ui.display.DisplayRow;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.ui.display.SourceChoice;
import org.robotui.ui.display.SourceName;
import org.robotui.ui.scene.Ink;
import org.robotui.ui.scene.Placer;
import org.robotui.ui.scene.Scene;

/**
 * The layers of a view: those that the settings list, and those that robots offer beside them, made of the kinds that
 * bundles bring, fed and prepared into a scene. Worker thread, where nothing else is said.
 */
public final class LayerStack {
  /** The setting that lists layers. */
  public static final String LAYERS = "layers";

  /** What a view decides about its layers. */
  public interface Rules {
    /**
     * A layer that is shown by itself, before the user changes it.
     *
     * @param spec as it comes
     * @return as the older settings of the view have it: hidden, with settings
     */
    DisplaySpec begin(DisplaySpec spec);

    /**
     * The colour of what a source gives, where there are several robots.
     *
     * @param source where data come from
     * @return which of the theme's traces; none where there is one robot only, whose things have colours by what they
     * are
     */
    OptionalInt trace(SourceId source);

    /**
     * What a layer of a source is called that has no name in the list.
     *
     * @param source where data come from
     * @return the name; none for that of its kind
     */
    default Optional<String> name(SourceId source) {
      return Optional.empty();
    }
  }

  private final LayerType.Ground ground;
  private final Scene scene;
  private final SettingsStore settings;
  private final Supplier<List<LayerType>> kinds;
  private final LayerInputs inputs;
  private final LayerContext context;
  private final Rules rules;
  private final DisplayList list;
  private final Map<String, LayerSlot> slots = new LinkedHashMap<>();
  private volatile Basis basis = new Basis(List.of(), List.of(), List.of(), Map.of());
  private volatile List<DisplayRow> rows = List.of();
  private volatile Map<String, Envelope<? extends Data>> newest = Map.of();
  private volatile List<ColorBar> colors = List.of();
  private List<LayerNote> notes = List.of();

  /** What the list of layers depends on. */
  private record Basis(List<LayerType> types, List<Input.Candidate> offered, List<Input.Candidate> automatic,
      Map<String, Object> written) {
    Map<String, LayerType> byId() {
      return types.stream().collect(Collectors.toMap(LayerType::id, Function.identity(), (a, b) -> a));
    }
  }

  /**
   * Without layers.
   *
   * @param ground on which layers of the view lie
   * @param scene where they go
   * @param view what core gives to the view
   * @param inputs where data come from
   * @param kinds those that bundles bring now
   * @param rules of the view
   */
  public LayerStack(LayerType.Ground ground, Scene scene, UicContext view, LayerInputs inputs,
      Supplier<List<LayerType>> kinds, Rules rules) {
    this.ground = ground;
    this.scene = scene;
    this.settings = view.settings();
    this.kinds = kinds;
    this.inputs = inputs;
    this.context = new Context(view);
    this.rules = rules;
    this.list = new DisplayList(settings, LAYERS, DisplayList.Growth.FIRST, this::specs);
  }

  /**
   * What the user changes; any thread.
   *
   * @return the list, topmost first
   */
  public DisplayList list() {
    return list;
  }

  /**
   * The kinds of which a layer can be added; any thread.
   *
   * @return those that can lie on the ground of the view
   */
  public List<DisplayKind> kinds() {
    return types().stream().map(LayerStack::kind).toList();
  }

  /**
   * The layers as users see them; any thread.
   *
   * @return topmost first, as of the last tick
   */
  public List<DisplayRow> rows() {
    return rows;
  }

  /**
   * What users should know of layers.
   *
   * @return as of the last tick
   */
  public List<LayerNote> notes() {
    return notes;
  }

  /**
   * The states of what layers may be fed from.
   *
   * @return of all sources, and of ports that have none
   */
  public List<InputState> states() {
    return inputs.states();
  }

  /**
   * What the colours of layers mean; any thread.
   *
   * @return as of the last tick, those of the topmost layer first
   */
  public List<ColorBar> colors() {
    return colors;
  }

  /**
   * The layers that show a stream; any thread.
   *
   * @param source the stream
   * @return their ids, as of the last tick
   */
  public List<String> of(SourceId source) {
    return newest.entrySet().stream().filter(e -> e.getValue().source().equals(source)).map(Map.Entry::getKey).toList();
  }

  /**
   * Adds a layer for a stream that none shows; any thread.
   *
   * @param source the stream
   * @return its id, or none where no kind takes the stream
   */
  public Optional<String> add(SourceId source) {
    return basis.types().stream()
        .filter(type -> type.accepts().stream()
            .anyMatch(data -> SourceChoice.fitting(data, basis.offered()).contains(source)))
        .findFirst()
        .map(type -> list.add(type.id(), SourceName.of(source)));
  }

  /**
   * Where a layer's data come from and how old they are; any thread.
   *
   * @param layer its id
   * @param nowNanos now
   * @return the words, or none where it has no data
   */
  public Optional<String> detail(String layer, long nowNanos) {
    return Optional.ofNullable(newest.get(layer))
        .map(e -> e.source() + "  \u00b7  " + Figures.age(Math.max(0, e.ageSeconds(nowNanos))) + " ago");
  }

  /**
   * Takes what came, without showing it yet.
   *
   * @param reset whether the clock of the robot jumped back
   * @return the frames that data are given in
   */
  public List<FrameId> take(boolean reset) {
    inputs.look();
    Basis next = new Basis(types(), inputs.all(), inputs.automatic(), settings.current().values());
    if (!next.equals(basis)) {
      basis = next;
      configure(next);
    }
    inputs.drain(reset);
    return inputs.named();
  }

  /**
   * Prepares all layers from what was taken.
   *
   * @param placer of the fixed frame, where the ground has frames
   * @param origin of the plane, where the ground is the earth
   * @param robots on the map
   * @param nowNanos now
   * @param reset whether the clock of the robot jumped back
   * @return whether there is something new to show
   */
  public boolean prepare(Optional<Placer> placer, Optional<EarthOrigin> origin, List<SeenRobot> robots, long nowNanos,
      boolean reset) {
    boolean changed = false;
    Map<String, Integer> below = new HashMap<>();
    Map<String, Integer> counts = new HashMap<>();
    slots.values().forEach(slot -> counts.merge(slot.spec().type(), 1, Integer::sum));
    List<LayerSlot> lowestFirst = new ArrayList<>(slots.values()).reversed();
    for (int order = 0; order < lowestFirst.size(); order++) {
      LayerSlot slot = lowestFirst.get(order);
      int number = below.merge(slot.spec().type(), 1, Integer::sum) - 1;
      if (slot.type().isPresent()) {
        LayerEntry entry =
            new LayerEntry("", number, counts.get(slot.spec().type()), ink(slot), slot.settings().settings());
        slot.name(slot.choice().sources().stream().findFirst().flatMap(rules::name));
        changed |= slot.update(inputs, context,
            new LayerTick(List.of(), slot.state(), placer, origin, robots, entry, nowNanos, reset), order);
      }
    }
    return changed | tell();
  }

  private final class Context implements LayerContext {
    private final UicContext view;

    Context(UicContext view) {
      this.view = view;
    }

    @Override
    public Executor background() {
      return view.background();
    }

    @Override
    public Optional<StreamHistory> history(SourceId source) {
      return inputs.history(source);
    }
  }

  private Ink ink(LayerSlot slot) {
    return Inks.chosen(slot.settings().settings())
        .orElseGet(() -> slot.choice().sources().stream().findFirst().map(rules::trace)
            .filter(OptionalInt::isPresent).<Ink>map(trace -> new Ink.Trace(trace.getAsInt())).orElse(Ink.USUAL));
  }

  private boolean tell() {
    Map<String, Envelope<? extends Data>> values = new LinkedHashMap<>();
    slots.forEach((id, slot) -> slot.newest().ifPresent(e -> values.put(id, e)));
    newest = Map.copyOf(values);
    colors = slots.values().stream().flatMap(slot -> slot.colors().stream()).toList();
    List<DisplayRow> listed = slots.values().stream().map(LayerSlot::row).toList();
    List<LayerNote> said = LayerNotes.of(new ArrayList<>(slots.values()).reversed());
    boolean changed = !listed.equals(rows) || !said.equals(notes);
    rows = listed;
    notes = said;
    return changed;
  }

  private List<LayerType> types() {
    return kinds.get().stream().filter(type -> type.grounds().contains(ground)).toList();
  }

  /** The layers as they are listed now, also those that nobody wrote; any thread. */
  private List<DisplaySpec> specs() {
    Settings current = settings.current();
    List<DisplaySpec> written = DisplayCodec.read(current, LAYERS);
    Basis now = basis;
    return current.flag(DisplayEntry.AUTOMATIC)
        ? new LayerOffers(now.types(), now.byId(), now.automatic(), inputs::hasPort, rules).beside(written)
        : written;
  }

  private void configure(Basis now) {
    Map<String, LayerType> byId = now.byId();
    Map<String, LayerSlot> before = new HashMap<>(slots);
    slots.clear();
    for (DisplaySpec spec : specs()) {
      LayerSlot slot = Optional.ofNullable(before.get(spec.id())).filter(s -> s.spec().type().equals(spec.type()))
          .orElseGet(() -> new LayerSlot(scene, spec));
      before.remove(spec.id(), slot);
      slot.configure(spec, Optional.ofNullable(byId.get(spec.type())), now.offered());
      slots.put(spec.id(), slot);
    }
    before.values().forEach(LayerSlot::end);
    Set<SourceId> wanted = new HashSet<>();
    slots.values().stream().filter(LayerSlot::wanted).forEach(s -> wanted.addAll(s.taken()));
    inputs.choose(wanted);
  }

  /**
   * A kind of layer, as lists know it.
   *
   * @param type the kind
   * @return the same for the list
   */
  public static DisplayKind kind(LayerType type) {
    return new DisplayKind(type.id(), type.label(), type.accepts(), type.needs(), type.automatic(), type.schema());
  }

  /** Topmost first. */
  static Comparator<LayerType> topmost() {
    return Comparator.comparingInt(LayerType::level).reversed().thenComparing(LayerType::id);
  }
}
