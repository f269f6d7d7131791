package org.robotui.uic.plot.internal.view;

import java.time.ZoneId;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.SaveDialog;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.Replay;
import org.robotui.uic.plot.internal.trace.TimeSpan;

/** What is seen of the view while it is shown. Display thread. */
public final class PlotSurface implements ViewSurface {
  private static final int PANEL = 300;
  private static final int LEAST_PLOT = 200;
  private static final int EMPTY_HEIGHT = 60;
  private static final int NOTICE = 40;

  private final UiContext context;
  private final StateView states;
  private final Edits edits;
  private final Exporter exporter;
  private final Composite root;
  private final PaintedCanvas canvas;
  private final PlotPainter painter;
  private final PlotState state;
  private final Navigation navigation;
  private final PlotMenu menu;
  private final ChooserPanel chooser;
  private final StatisticsPane statistics;
  private final BinsPane bins;
  private final PortAdder ports;
  private final DropZone drops;
  private final QuietButton choose;
  private volatile boolean choosing;
  private PlotScene scene;

  /**
   * Makes the controls.
   *
   * @param state where the user looks; kept when the control is made anew
   */
  public PlotSurface(
      Composite parent, UiContext context, PlotScene scene, PlotState state, Edits edits, Exporter exporter,
      ChooserPanel.Robot robot) {
    this.context = context;
    this.scene = scene;
    this.state = state;
    this.edits = edits;
    this.exporter = exporter;
    this.states = new StateView(context.theme());
    this.painter = new PlotPainter(context.theme(), ZoneId.systemDefault());
    this.root = new Composite(parent, SWT.NONE);
    root.setBackground(context.theme().color(Role.PANEL));
    this.canvas = new PaintedCanvas(root, context.theme(), this::paint);
    this.chooser =
        new ChooserPanel(root, context.theme(), robot, text -> edits.add(text, lastAxis()), edits::fault,
            this::closeChooser);
    this.statistics = new StatisticsPane(root, context.theme(), () -> showStatistics(true));
    this.bins = new BinsPane(root, context.theme(), exporter.background(), exporter::write,
        () -> showStatistics(false));
    this.navigation = new Navigation(canvas, () -> this.scene, state, painter);
    this.menu = new PlotMenu(edits, new Commands(), robot.ports(context.theme()));
    this.ports = new PortAdder(canvas, robot, new Ports());
    this.drops = new DropZone(canvas, painter, ports);
    this.choose = new QuietButton(canvas, context.theme(), () -> choose("")).icon(Icon.PLUS).text("Choose a field")
        .fill(Role.ACCENT);
    listen();
  }

  @Override
  public Control control() {
    return root;
  }

  public void show(PlotScene next) {
    if (canvas.isDisposed()) {
      return;
    }
    if (next.axes().size() != scene.axes().size()) {
      state.forgetScales();
    }
    boolean others = !next.spec().equals(scene.spec());
    scene = next;
    showStatistics(others);
    if (others) {
      place();
    }
    context.note(note());
    choose.setVisible(scene.axes().isEmpty() && !chooser.isOpen());
    chooser.refresh();
    canvas.redraw();
  }

  /** Shows the list of fields, with something typed. */
  public void choose(String typed) {
    chooser.open(typed);
    choosing = true;
    choose.setVisible(false);
    place();
  }

  /** Plots fields of a port; without any named, the user chooses. */
  public void plot(Subject.Stream stream) {
    if (stream.fields().isEmpty()) {
      choose(stream.port());
    } else {
      ports.signals(PortAdder.signals(stream.port(), stream.fields()), new DropZone.Place(lastAxis(), false));
    }
  }

  private void choose(SourceId source) {
    choose("");
    chooser.open(source);
  }

  public void toggleChooser() {
    if (chooser.isOpen()) {
      closeChooser();
    } else {
      choose("");
    }
  }

  /** Whether the list of fields is open. Any thread. */
  public boolean isChoosing() {
    return choosing;
  }

  /** Whether time stands: what is seen neither is live nor goes along with a recording. */
  public boolean isHeld() {
    return scene.replay().isPresent() ? !state.isFollowing() : !state.isLive();
  }

  public void pause() {
    navigation.pause();
    show(scene);
  }

  public void live() {
    navigation.live();
    show(scene);
  }

  public void cursors() {
    navigation.cursors();
  }

  /** Shows the statistics below the axes, or takes them away. */
  public void statistics() {
    statistics.open(!statistics.isOpen());
    showStatistics(true);
    place();
  }

  /** Shows histograms below the axes, or takes them away. */
  public void histograms() {
    bins.open(!bins.isOpen());
    showStatistics(true);
    place();
  }

  public boolean showsHistograms() {
    return bins.isOpen();
  }

  private void showStatistics(boolean now) {
    statistics.show(scene, state, now);
    bins.show(scene, state);
  }

  public boolean showsStatistics() {
    return statistics.isOpen();
  }

  /** Asks for a file and writes what is seen, or all, to it. */
  public void export(boolean all) {
    if (scene.spec().isEmpty()) {
      exporter.say("there are no traces to export", false);
      show(scene);
      return;
    }
    TimeSpan span = all ? scene.extent().orElse(state.span(scene, 0)) : state.span(scene, 0);
    SaveDialog.ask(canvas, "Export traces", "plot.csv", "*.csv")
        .ifPresent(file -> exporter.export(scene, span, file.toString()));
  }

  private void picture() {
    PictureSaver saver = new PictureSaver(context.theme(), painter, exporter);
    SaveDialog.ask(canvas, "Save the plot as SVG or PNG", "plot.svg", "*.svg", "*.png")
        .ifPresent(file -> saver.save(canvas, scene, state, file));
  }

  private int lastAxis() {
    return Math.max(0, scene.axes().size() - 1);
  }

  private void closeChooser() {
    chooser.hide();
    choosing = false;
    place();
    canvas.setFocus();
    show(scene);
  }

  private void listen() {
    navigation.listen();
    root.addListener(SWT.Dispose, e -> state.tell(OptionalLong.empty()));
    root.addListener(SWT.Resize, e -> place());
    canvas.addListener(SWT.MenuDetect, e -> {
      Point at = canvas.toControl(e.x, e.y);
      menu.open(canvas, scene, state, painter, at);
    });
    canvas.addListener(SWT.MouseUp, this::clicked);
    canvas.addListener(SWT.MouseMove, this::hover);
    canvas.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.INSERT || e.keyCode == 'a' && (e.stateMask & SWT.MODIFIER_MASK) == 0) {
        choose("");
      } else if (e.keyCode == 's' && (e.stateMask & SWT.MODIFIER_MASK) == 0) {
        statistics();
      } else if (e.keyCode == 'h' && (e.stateMask & SWT.MODIFIER_MASK) == 0) {
        histograms();
      }
    });
    canvas.addListener(SWT.Paint, e -> showStatistics(false));
  }

  /** A click on the name of a trace hides or shows it. */
  private void clicked(Event event) {
    if (event.button == 1) {
      place(event).ifPresent(p -> edits.axes(s -> s.with(p.trace(), t -> t.withHidden(!t.hidden()))));
    }
  }

  private void hover(Event event) {
    String words = place(event).map(p -> p.row().tooltip()).orElse(null);
    if (!Objects.equals(words, canvas.getToolTipText())) {
      canvas.setToolTipText(words);
    }
  }

  private Optional<LegendPainter.Place> place(Event event) {
    return painter.places().stream().filter(p -> p.at().contains(event.x, event.y)).findFirst();
  }

  private void place() {
    Rectangle area = root.getClientArea();
    int list = area.width - PANEL < LEAST_PLOT ? area.width : PANEL;
    int panel = chooser.isOpen() ? list : 0;
    chooser.control().setBounds(0, 0, panel, area.height);
    int counted = bins.height(area.height);
    int below = counted + statistics.height(scene, area.height - counted);
    canvas.setBounds(panel, 0, Math.max(0, area.width - panel), area.height - below);
    int wide = Math.max(0, area.width - panel);
    bins.control().setBounds(panel, area.height - below, wide, counted);
    statistics.control().setBounds(panel, area.height - below + counted, wide, below - counted);
    Point size = choose.computeSize(SWT.DEFAULT, SWT.DEFAULT);
    choose.setBounds((area.width - size.x) / 2, area.height / 2 + EMPTY_HEIGHT / 2, size.x, size.y);
  }

  private String note() {
    if (scene.spec().isEmpty()) {
      return "";
    }
    long broken = scene.traces().filter(t -> t.problem().isPresent()).count();
    String span = Figures.age(state.span(scene, 0).seconds());
    if (scene.replay().isPresent()) {
      return (broken > 0 ? broken + " without values \u00b7 " : "") + span + " \u00b7 " + time(scene.replay().get());
    }
    String time = state.isLive() ? "live" : "paused";
    return (broken > 0 ? broken + " without values \u00b7 " : "") + span + " \u00b7 " + time;
  }

  private String time(Replay replay) {
    if (replay.progress().isPresent()) {
      return "reading, " + Math.round(replay.progress().getAsDouble() * 100) + " %";
    }
    return state.isFollowing() ? "follows the recording" : state.isLive() ? "whole recording" : "part of the recording";
  }

  private void paint(GC gc, Rectangle area) {
    if (scene.axes().isEmpty() && !drops.isOver()) {
      Rectangle above = new Rectangle(area.x, area.y, area.width, area.height - EMPTY_HEIGHT / 2);
      states.message(gc, above, Health.NONE, "Nothing to plot yet", "Drop a field here, or press + to choose one.");
    }
    painter.paint(gc, area, scene, state);
    drops.paint(gc, area);
    notices(gc, area);
  }

  private void notices(GC gc, Rectangle area) {
    Rectangle across = painter.frames().isEmpty() ? area : painter.frames().getLast().plot();
    Rectangle low =
        new Rectangle(across.x, Math.max(area.y, area.y + area.height - Frames.TIMES - NOTICE), across.width, NOTICE);
    Optional<Exporter.Notice> notice = exporter.notice(System.nanoTime());
    if (notice.isPresent()) {
      String words = TextFit.shorten(gc, notice.get().text(), area.width - 6 * Theme.EDGE);
      states.banner(gc, low, notice.get().good() ? Health.OK : Health.BAD, words);
    } else if (!state.isLive() && scene.replay().isEmpty() && !scene.spec().isEmpty()) {
      states.banner(gc, low, Health.NONE, "paused \u00b7 double-click for live");
    }
  }

  private final class Ports implements PortAdder.Plot {
    @Override
    public void add(String signals, int axis) {
      edits.add(signals, axis).ifPresent(this::refuse);
    }

    @Override
    public void over(String signal, int axis) {
      edits.over(signal, axis).ifPresent(this::refuse);
      state.unzoom(axis);
    }

    @Override
    public void choose(SourceId port) {
      PlotSurface.this.choose(port);
    }

    @Override
    public void refuse(String reason) {
      exporter.say("cannot plot that: " + reason, false);
      show(scene);
    }
  }

  private final class Commands implements PlotMenu.Commands {
    @Override
    public void choose(String text) {
      PlotSurface.this.choose(text);
    }

    @Override
    public void pause() {
      PlotSurface.this.pause();
    }

    @Override
    public void all() {
      PlotSurface.this.live();
    }

    @Override
    public void cursors() {
      PlotSurface.this.cursors();
    }

    @Override
    public void statistics() {
      PlotSurface.this.statistics();
    }

    @Override
    public void histograms() {
      PlotSurface.this.histograms();
    }

    @Override
    public void copyStatistics() {
      StatisticsPane.copy(scene, state);
    }

    @Override
    public void export(boolean all) {
      PlotSurface.this.export(all);
    }

    @Override
    public void picture() {
      PlotSurface.this.picture();
    }

    @Override
    public void zoomBack(int axis) {
      state.unzoom(axis);
      canvas.redraw();
    }
  }
}
