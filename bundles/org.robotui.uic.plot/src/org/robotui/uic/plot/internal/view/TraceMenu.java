package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.show.Subject;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotOptions;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.SignalNames;
import org.robotui.uic.plot.internal.model.TraceRef;
import org.robotui.uic.plot.internal.model.TraceSpec;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.signal.Expr;

/** What can be done with a trace. Display thread. */
final class TraceMenu {
  private static final double[] LIMITS = {0.1, 0.5, 1, 5, 10};
  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");
  private static final double[] AVERAGES = {0.1, 0.5, 1, 5, 10};

  private final Edits edits;
  private final Consumer<String> type;
  private final SubjectMenu ports;

  /** Given also what is called with a signal that the user wants to go on typing. */
  TraceMenu(Edits edits, Consumer<String> type, SubjectMenu ports) {
    this.ports = ports;
    this.edits = edits;
    this.type = type;
  }

  void fill(PopupMenu menu, PlotScene scene, TraceRef ref) {
    TraceView trace = scene.axes().get(ref.axis()).get(ref.trace());
    TraceSpec spec = trace.spec();
    menu.push(spec.hidden() ? "Show" : "Hide", () -> change(ref, t -> t.withHidden(!t.hidden())));
    menu.push("Remove", () -> edits.axes(s -> s.without(ref)));
    menu.line();
    derive(menu.under("Derive"), scene, ref, spec.signal());
    over(menu.under("Plot over"), scene, spec.signal());
    colours(menu.under("Colour"), ref, trace.colour());
    styles(menu.under("Line"), ref, spec.style());
    menu.check("Right scale", spec.right(), now -> change(ref, t -> t.withRight(!t.right())));
    move(menu.under("Move to"), scene, ref);
    menu.line();
    menu.push("Copy signal", () -> Clipboards.copy(spec.signal()));
    menu.push("Name the signal\u2026", !isName(scene, spec.signal()), () -> name(menu.widget().getShell(), scene, ref));
    fields(scene, spec.signal()).forEach(
        field -> ports.fill(menu.under(field.toString()), new Subject.Stream(field.source(), List.of(field.path()))));
  }

  /** The fields that a signal is made of; none of one that cannot be read. */
  private static List<Expr.Field> fields(PlotScene scene, String signal) {
    try {
      return new SignalNames(scene.spec().names()).read(signal).fields().distinct().toList();
    } catch (IllegalArgumentException e) {
      return List.of();
    }
  }

  private static boolean isName(PlotScene scene, String word) {
    return scene.spec().names().stream().anyMatch(named -> named.name().equals(word));
  }

  private void name(Control over, PlotScene scene, TraceRef ref) {
    NameDialog.ask(over, "Name of the signal", "", word -> NAME.matcher(word.strip()).matches()
        && !isName(scene, word.strip())).ifPresent(word -> edits.name(ref, word.strip()));
  }

  private void derive(PopupMenu menu, PlotScene scene, TraceRef ref, String signal) {
    menu.push("Derivative", () -> add(ref, "derivative(" + signal + ")"));
    menu.push("Integral", () -> add(ref, "integral(" + signal + ")"));
    PopupMenu averages = menu.under("Moving average");
    for (double seconds : AVERAGES) {
      averages.push(seconds + " s", () -> add(ref, "average(" + signal + ", " + seconds + ")"));
    }
    PopupMenu filters = menu.under("Low-pass");
    for (double hertz : LIMITS) {
      filters.push(hertz + " Hz", () -> add(ref, "lowpass(" + signal + ", " + hertz + ")"));
    }
    menu.push("Angle without jumps", () -> add(ref, "unwrap(" + signal + ")"));
    menu.push("Calculate\u2026", () -> type.accept("(" + signal + ") * 1 + 0"));
    PopupMenu scale = menu.under("Scale");
    scale.push("Radians to degrees", () -> add(ref, "scale(" + signal + ", " + Math.toDegrees(1) + ")"));
    scale.push("Negate", () -> add(ref, "scale(" + signal + ", -1)"));
    scale.push("Thousand times", () -> add(ref, "scale(" + signal + ", 1000)"));
    scale.push("Factor and offset\u2026", () -> type.accept("scale(" + signal + ", 1, 0)"));
    others(menu.under("Difference to"), scene, ref, signal);
    List<TraceView> same = scene.axes().get(ref.axis());
    if (same.size() > 1) {
      menu.push("Norm of all on this axis",
          () -> add(ref, same.stream().map(t -> t.spec().signal()).collect(Collectors.joining(", ", "norm(", ")"))));
    }
  }

  /** On an axis of its own, or on the one that has that scale already. */
  private void over(PopupMenu menu, PlotScene scene, String signal) {
    scene.traces().filter(t -> !t.spec().signal().equals(signal))
        .forEach(t -> menu.push(t.label(), () -> edits.curve(signal, t.spec().signal())));
    menu.push("Another\u2026", () -> type.accept(signal + Edits.OVER));
  }

  private void others(PopupMenu menu, PlotScene scene, TraceRef ref, String signal) {
    List<TraceView> others = scene.traces().filter(t -> !t.spec().signal().equals(signal)).toList();
    others.forEach(t -> menu.push(t.label(), () -> add(ref, "difference(" + signal + ", " + t.spec().signal() + ")")));
    menu.push("Another\u2026", () -> type.accept("difference(" + signal + ", )"));
  }

  private void colours(PopupMenu menu, TraceRef ref, int now) {
    for (int i = 0; i < PlotOptions.COLOURS.size(); i++) {
      int colour = i;
      menu.radio(PlotOptions.COLOURS.get(i), i == now, () -> change(ref, t -> t.withColour(colour)));
    }
  }

  private void styles(PopupMenu menu, TraceRef ref, Optional<LineStyle> now) {
    menu.radio("as the others", now.isEmpty(), () -> change(ref, t -> t.withStyle(Optional.empty())));
    for (LineStyle style : LineStyle.values()) {
      menu.radio(style.word(), now.equals(Optional.of(style)), () -> change(ref, t -> t.withStyle(Optional.of(style))));
    }
  }

  private void move(PopupMenu menu, PlotScene scene, TraceRef ref) {
    for (int i = 0; i < scene.axes().size(); i++) {
      int axis = i;
      if (i != ref.axis()) {
        menu.push("Axis " + (i + 1), () -> edits.axes(s -> s.moved(ref, axis)));
      }
    }
    menu.push("New axis", () -> edits.axes(s -> s.moved(ref, s.axes().size())));
  }

  private void add(TraceRef ref, String signal) {
    edits.axes(s -> s.plus(ref.axis(), new TraceSpec(signal, Optional.empty(), Optional.empty(), OptionalInt.empty(),
        Optional.empty(), s.trace(ref).map(TraceSpec::right).orElse(false), false)));
  }

  private void change(TraceRef ref, UnaryOperator<TraceSpec> change) {
    edits.axes(s -> s.with(ref, change));
  }
}
