package org.robotui.workbench.internal.timeline;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.replay.ComparisonReport;
import org.robotui.api.replay.ComparisonReport.ComparedError;
import org.robotui.api.replay.ComparisonWish;
import org.robotui.api.replay.ComparisonWish.Alignment;
import org.robotui.api.replay.ComparisonWish.Pairing;
import org.robotui.api.replay.Lane;
import org.robotui.api.replay.Track;
import org.robotui.api.time.PointedTime;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.control.SaveDialog;

/** A window beside the views that says how far two recordings are apart. Display thread only. */
final class CompareWindow {
  private static final int WIDTH = 980;
  private static final int HEIGHT = 520;
  private static final int TABLE = 136;
  private static final int MOST_TOPICS = 30;
  private static final String EXAMPLE = "odom, or a number: odom linear.x";
  private static final String ONE_ALONE = "open a second recording to compare this one with: File > Open Recording";
  private static final Map<Pairing, String> PAIRINGS = Map.of(Pairing.TIME, "At the Same Time", Pairing.START,
      "Since the First Value", Pairing.WAY, "After the Same Way");
  private static final Map<Alignment, String> ALIGNMENTS = Map.of(Alignment.NONE, "Not Moved", Alignment.ORIGIN,
      "Moved by the First Pose", Alignment.YAW, "Best Fit in the Plane", Alignment.SE3, "Best Fit");

  private final Theme theme;
  private final LiveTimeline live;
  private final RunCompare compare;
  private final BesideShell frame;
  private final Shell shell;
  private final QuietButton first;
  private final QuietButton second;
  private final Text topic;
  private final QuietButton topics;
  private final QuietButton pairing;
  private final QuietButton alignment;
  private final QuietButton go;
  private final NoticeLine said;
  private final RowTable<ComparedError> table;
  private final ErrorChart chart;
  private final QuietButton over;
  private final QuietButton save;
  private boolean overWay;
  private Optional<Track> one = Optional.empty();
  private Optional<Track> other = Optional.empty();
  private Pairing paired = Pairing.TIME;
  private Alignment aligned = Alignment.NONE;

  /** Over the window of a control; opened by {@link #open}. */
  CompareWindow(Control under, Theme theme, LiveTimeline live, RunCompare compare, PointedTime pointed) {
    this.theme = theme;
    this.live = live;
    this.compare = compare;
    frame = new BesideShell(under, theme, "Compare Recordings");
    shell = frame.shell();
    Composite how = frame.row(4);
    first = new QuietButton(how, theme, () -> recordings(this.first(), one, chosen -> one = chosen))
        .hint("The recording that is taken for right");
    second = new QuietButton(how, theme, () -> recordings(this.second(), other, chosen -> other = chosen))
        .hint("The recording that is compared with it");
    pairing = new QuietButton(how, theme, this::pairings).hint("Which values of both belong together");
    alignment = new QuietButton(how, theme, this::alignments)
        .hint("How the way of the second is moved onto that of the first before both are compared");
    Composite what = frame.row(3);
    topic = frame.field(what, EXAMPLE, this::start);
    topics = new QuietButton(what, theme, this::topics).icon(Icon.MORE).hint("Topics that both recordings have");
    go = new QuietButton(what, theme, this::start).text("Compare");
    said = frame.notice();
    table = table();
    chart = new ErrorChart(shell, theme, pointed, time -> live.timeline().ifPresent(t -> t.seek(time)));
    frame.fill(chart.control());
    Composite drawn = frame.row(2);
    over = new QuietButton(drawn, theme, this::turn).hint("What the errors are drawn over");
    save = new QuietButton(drawn, theme, this::save).icon(Icon.SAVE).text("Save All Errors as CSV\u2026");
    table.list().onSelect(rows -> draw());
    Runnable news = compare.onChange(this::show);
    Runnable moved = live.onChange(this::show);
    shell.addListener(SWT.Dispose, e -> {
      news.run();
      moved.run();
    });
    show();
  }

  private void turn() {
    overWay = !overWay;
    show();
  }

  private void save() {
    SaveDialog.ask(shell, "Save Errors", "errors.csv", "*.csv").ifPresent(compare::save);
  }

  /** The errors of the row that is chosen, at first of the first. */
  private void draw() {
    List<ComparedError> errors = compare.standing().report().map(ComparisonReport::errors).orElse(List.of());
    Optional<ComparedError> chosen = table.list().selected().stream().findFirst()
        .flatMap(row -> errors.stream().filter(each -> each.name().equals(row.name())).findFirst())
        .or(() -> errors.stream().findFirst());
    chart.show(chosen, overWay);
  }

  private QuietButton first() {
    return first;
  }

  private QuietButton second() {
    return second;
  }

  private RowTable<ComparedError> table() {
    List<Column<ComparedError>> columns = List.of(
        Column.<ComparedError>words("Error", ComparedError::title).weight(1),
        Column.<ComparedError>figures("RMSE", error -> figure(error.rmse())).width(84),
        Column.<ComparedError>figures("Mean", error -> figure(error.mean())).width(84),
        Column.<ComparedError>figures("Median", error -> figure(error.median())).width(84),
        Column.<ComparedError>figures("Std", error -> figure(error.deviation())).width(84),
        Column.<ComparedError>figures("Least", error -> figure(error.least())).width(84),
        Column.<ComparedError>figures("Most", error -> figure(error.most())).width(84));
    RowTable<ComparedError> made = new RowTable<>(shell, theme, columns, ComparedError::name);
    frame.keep(made.control(), TABLE);
    made.list().named("Errors");
    return made;
  }

  private static String figure(double value) {
    return String.format(Locale.ROOT, "%.5f", value);
  }

  /** Shows it, or brings it to the front. */
  void open() {
    frame.open(WIDTH, HEIGHT, true);
    focus();
  }

  /** Takes the keys. */
  void focus() {
    shell.setActive();
    topic.setFocus();
  }

  boolean isClosed() {
    return shell.isDisposed();
  }

  void close() {
    shell.dispose();
  }

  /** For tests. */
  Shell shell() {
    return shell;
  }

  /** A topic of a recording is to be compared with that of another one. */
  void propose(Track track, String name) {
    other = Optional.of(track);
    one = one.filter(each -> !each.id().equals(track.id())); // another one is taken for right
    topic.setText(name.startsWith("/") ? name.substring(1) : name);
    topic.selectAll();
    show();
  }

  private void recordings(QuietButton button, Optional<Track> now, Consumer<Optional<Track>> chosen) {
    PopupMenu menu = new PopupMenu(button, this::show);
    live.tracks().forEach(each -> menu.radio(name(each), now.filter(each::equals).isPresent(),
        () -> chosen.accept(Optional.of(each))));
    menu.openBelow(button);
  }

  private static String name(Track track) {
    return track.file().getFileName().toString();
  }

  /** Those that say where something is come first. */
  private void topics() {
    PopupMenu menu = new PopupMenu(topics);
    Set<String> others = other.stream().flatMap(each -> each.lanes().stream()).map(Lane::topic)
        .collect(Collectors.toSet());
    one.stream().flatMap(each -> each.lanes().stream()).filter(each -> others.contains(each.topic()))
        .sorted(Comparator.comparing((Lane each) -> !each.type().matches(".*(Odometry|Pose).*"))
            .thenComparing(Lane::topic))
        .limit(MOST_TOPICS).forEach(each -> menu.push(each.topic() + "  " + each.type(), () -> {
          topic.setText(each.topic().startsWith("/") ? each.topic().substring(1) : each.topic());
          topic.setFocus();
        }));
    menu.openBelow(topics);
  }

  private void pairings() {
    PopupMenu menu = new PopupMenu(pairing, this::show);
    for (Pairing each : Pairing.values()) {
      menu.radio(PAIRINGS.get(each), each == paired, () -> paired = each);
    }
    menu.openBelow(pairing);
  }

  private void alignments() {
    PopupMenu menu = new PopupMenu(alignment, this::show);
    for (Alignment each : Alignment.values()) {
      menu.radio(ALIGNMENTS.get(each), each == aligned, () -> aligned = each);
    }
    menu.openBelow(alignment);
  }

  private void start() {
    String words = topic.getText().strip();
    if (words.isEmpty() || one.isEmpty() || other.isEmpty()) {
      said.show(Health.BAD,
          words.isEmpty() ? "write a topic that says where the robot was, or a number of one" : ONE_ALONE);
      return;
    }
    compare.start(new ComparisonWish(one.get().id(), other.get().id(), words, paired, aligned));
  }

  private void show() {
    if (shell.isDisposed()) {
      return;
    }
    List<Track> tracks = new ArrayList<>(live.tracks());
    other = kept(other, tracks).or(() -> tracks.stream().skip(1).findFirst());
    one = kept(one, tracks)
        .or(() -> tracks.stream().filter(each -> other.filter(each::equals).isEmpty()).findFirst());
    first.text("Reference: " + one.map(CompareWindow::name).orElse("none"));
    second.text("Compared: " + other.map(CompareWindow::name).orElse("none"));
    pairing.text("Values: " + PAIRINGS.get(paired));
    alignment.text("Way: " + ALIGNMENTS.get(aligned));
    go.setEnabled(!compare.standing().running());
    String words = compare.standing().words();
    said.show(compare.standing().health(), words.isEmpty() && other.isEmpty() ? ONE_ALONE : words);
    table.show(compare.standing().report().map(ComparisonReport::errors).orElse(List.of()));
    List<ComparedError> errors = table.list().rows();
    over.text(overWay ? "Drawn over the Way" : "Drawn over Time");
    over.setEnabled(errors.stream().anyMatch(each -> each.curve().knowsWay()));
    save.setEnabled(!errors.isEmpty());
    draw();
    shell.layout(true, true);
  }

  /** As it is now: a recording that was moved is another value. */
  private static Optional<Track> kept(Optional<Track> chosen, List<Track> tracks) {
    return chosen.flatMap(each -> tracks.stream().filter(now -> now.id().equals(each.id())).findFirst());
  }
}
