package org.robotui.uic.plot.internal;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.ui.Icon;
import org.robotui.ui.StateView;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;
import org.robotui.ui.show.NumberPaths;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.plot.internal.model.FieldTree;
import org.robotui.uic.plot.internal.model.PlotEngine;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.Records;
import org.robotui.uic.plot.internal.model.WholeSeries;
import org.robotui.uic.plot.internal.trace.TimeSpan;
import org.robotui.uic.plot.internal.view.ChooserPanel;
import org.robotui.uic.plot.internal.view.Edits;
import org.robotui.uic.plot.internal.view.Exporter;
import org.robotui.uic.plot.internal.view.PlotState;
import org.robotui.uic.plot.internal.view.PlotSurface;

/** The view: the tick records, the surface draws what is recorded. */
final class PlotUic extends SurfaceUic<PlotSurface> {
  private static final double STEPS = 1000;
  private static final double ALL_WINDOW = 60;

  private final UicContext context;
  private final Input<Data> input;
  private final PlotEngine engine;
  private final Exporter exporter;
  private final Edits edits;
  private final PlotState state;
  private volatile PlotScene scene;
  private long shownNow;
  private boolean noticing;
  private OptionalLong elsewhere = OptionalLong.empty();

  PlotUic(UicContext context) {
    this.context = context;
    this.input = context.input(PlotType.VALUES);
    this.state = new PlotState(context.pointed());
    this.engine = context.retained(PlotEngine.class)
        .map(before -> new PlotEngine(input, context.clock(), context.settings(), whole(context), before))
        .orElseGet(() -> new PlotEngine(input, context.clock(), context.settings(), whole(context)));
    this.exporter = new Exporter(context.background());
    this.edits = new Edits(context.settings());
    this.scene = engine.begin(System.nanoTime());
    offers().action("add", "Add a trace", Icon.PLUS, PlotSurface::toggleChooser)
        .switched("pause", "Pause", Icon.PAUSE, PlotSurface::isHeld, PlotSurface::pause)
        .switched("cursors", "Cursors", Icon.RULER, s -> state.cursors().isPresent(), PlotSurface::cursors)
        .switched("statistics", "Statistics", Icon.TEXT, PlotSurface::showsStatistics, PlotSurface::statistics)
        .switched("histograms", "Histograms", Icon.BARS, PlotSurface::showsHistograms, PlotSurface::histograms)
        .action("live", "Back to live, or to the whole recording", Icon.FIT, PlotSurface::live)
        .action("export", "Export what is seen\u2026", Icon.SAVE, s -> s.export(false));
  }

  private WholeSeries whole(UicContext given) {
    return new WholeSeries(input, given.background());
  }

  @Override
  public void close() {
    engine.close();
  }

  @Override
  public boolean tick(long nowNanos) {
    PlotScene next = engine.tick(nowNanos);
    boolean news = engine.tookValues() || !next.spec().equals(scene.spec()) || !looks(next).equals(looks(scene))
        || moved(next) || noticed(nowNanos) || pointed() || surface().filter(PlotSurface::isChoosing).isPresent();
    scene = next;
    shownNow = news ? next.now() : shownNow;
    return news;
  }

  /** Whether there is something to say, or was until now. */
  private boolean noticed(long nowNanos) {
    boolean before = noticing;
    noticing = exporter.notice(nowNanos).isPresent();
    return noticing || before;
  }

  /** Whether the user points at another time elsewhere. */
  private boolean pointed() {
    OptionalLong before = elsewhere;
    elsewhere = state.elsewhere();
    return !elsewhere.equals(before);
  }

  /** Whether time went on so far that it is seen. */
  private boolean moved(PlotScene next) {
    if (next.replay().isPresent() || scene.replay().isPresent()) {
      return !next.replay().equals(scene.replay()); // its position, or what was read
    }
    double window = next.spec().window() == 0 ? ALL_WINDOW : next.spec().window();
    return state.isLive() && !next.spec().isEmpty()
        && Math.abs(next.now() - shownNow) >= window / STEPS * TimeSpan.SECOND;
  }

  /** What words are seen of the traces. */
  private static List<String> looks(PlotScene scene) {
    return scene.traces().map(t -> StateView.word(t.state()) + t.problem() + t.unit() + t.lost()).toList();
  }

  @Override
  protected PlotSurface open(Composite parent, UiContext ui) {
    return new PlotSurface(parent, ui, scene, state, edits, exporter, new Robot());
  }

  @Override
  protected void refresh(PlotSurface shown) {
    shown.show(scene);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("A, Insert", "Add a trace"),
        new ViewKey("P", "Pause, or follow a recording"),
        new ViewKey("C", "Show cursors"),
        new ViewKey("S", "Show statistics"),
        new ViewKey("H", "Show histograms"),
        new ViewKey("0, Home", "Return to live, or to the whole recording"),
        new ViewKey("+, -", "Zoom time"),
        new ViewKey("Left, right", "Move in time"),
        new ViewKey("Shift+Up, down", "Zoom values"));
  }

  @Override
  public void show(String showing, Subject subject) {
    if (subject instanceof Subject.Stream stream) {
      surface().ifPresent(s -> s.plot(stream));
    }
  }

  @Override
  public Optional<Object> retain() {
    return Optional.of(engine);
  }

  private final class Robot implements ChooserPanel.Robot {
    @Override
    public List<Input.Candidate> candidates() {
      return input.candidates();
    }

    @Override
    public Optional<FieldTree.Learned> learned(SourceId source) {
      return engine.newest(source).map(envelope -> {
        DynamicRecord data = Records.data(envelope);
        DynamicRecord own = Records.own(envelope);
        return new FieldTree.Learned(data, own.schema().equals(data.schema()) ? Optional.empty() : Optional.of(own));
      });
    }

    @Override
    public String ruic() {
      return context.ruic().name();
    }

    @Override
    public List<String> numbers(SourceId source) {
      return context.ruic().newest(source).map(envelope -> NumberPaths.of(Records.data(envelope))).orElse(List.of());
    }

    @Override
    public SubjectMenu ports(Theme colours) {
      return new SubjectMenu(context, colours);
    }

    @Override
    public void watch(Set<SourceId> sources) {
      engine.watch(sources);
    }
  }
}
