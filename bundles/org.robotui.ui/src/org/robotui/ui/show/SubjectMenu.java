package org.robotui.ui.show;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Function;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.UicContext;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PopupMenu;

/**
 * The menu of a port, a field, a frame or a node, the same wherever it is listed: the views that show it, its name and
 * value for the clipboard, and what its type means. Display thread; values become texts elsewhere.
 */
public final class SubjectMenu {
  private static final int MOST_FIELDS = 24;

  private final RuicView ruic;
  private final Theme theme;
  private final Executor background;

  /**
   * Menus for the things of one RUIC.
   *
   * @param ruic whose
   * @param theme for the window that describes types
   * @param background where values are made into text, as {@link UicContext#background()}
   */
  public SubjectMenu(RuicView ruic, Theme theme, Executor background) {
    this.ruic = ruic;
    this.theme = theme;
    this.background = background;
  }

  /**
   * Menus of a view, for the things of its RUIC.
   *
   * @param view what core gives to the view
   * @param theme for the window that describes types
   */
  public SubjectMenu(UicContext view, Theme theme) {
    this(view.ruic(), theme, view.background());
  }

  /**
   * Opens the menu at the pointer.
   *
   * @param control where it was asked for
   * @param subject what the user points at
   */
  public void open(Control control, Subject subject) {
    PopupMenu menu = new PopupMenu(control);
    fill(menu, subject);
    menu.open();
  }

  /**
   * Adds its entries to a menu.
   *
   * @param menu the menu
   * @param subject what the user points at
   */
  public void fill(PopupMenu menu, Subject subject) {
    menu.line();
    List<ShowChoice> choices = ruic.showChoices(subject);
    choices.forEach(choice -> show(menu, label(choice, choices), choice, subject));
    menu.line();
    switch (subject) {
      case Subject.Stream stream -> stream(menu, stream);
      case Subject.Frame frame -> menu.push("Copy name", () -> Clipboards.copy(frame.frame().name()));
      case Subject.Node node -> menu.push("Copy name", () -> Clipboards.copy(node.name()));
    }
  }

  /** Where several views would do the same, their titles tell them apart. What opens a view says so. */
  private static String label(ShowChoice choice, List<ShowChoice> all) {
    if (choice.opens().isPresent()) {
      return choice.showing().label() + " (opens " + choice.title() + ")";
    }
    boolean several = all.stream().filter(c -> c.showing().equals(choice.showing())).count() > 1;
    return several ? choice.showing().label() + " (" + choice.title() + ")" : choice.showing().label();
  }

  private void show(PopupMenu menu, String label, ShowChoice choice, Subject subject) {
    if (!choice.possible()) {
      menu.unavailable(label, choice.obstacle());
    } else if (choice.showing().kind() == Showing.Kind.NUMBERS && subject instanceof Subject.Stream stream) {
      numbers(menu, label, choice, stream);
    } else {
      menu.push(label, () -> ruic.show(choice, subject));
    }
  }

  /** The numbers of the newest value; where there is none yet, the view lets the user choose. */
  private void numbers(PopupMenu menu, String label, ShowChoice choice, Subject.Stream stream) {
    Optional<List<String>> known = ruic.newest(stream.port()).map(newest -> numbers(newest, stream.fields()));
    List<String> paths = known.orElse(stream.fields());
    if (paths.isEmpty() && known.isPresent()) {
      menu.unavailable(label, stream.fields().isEmpty() ? "has no number now" : "no number");
    } else if (paths.isEmpty()) {
      menu.push(label + "\u2026", () -> ruic.show(choice, stream));
    } else if (paths.size() == 1 || paths.equals(stream.fields())) {
      menu.push(stream.fields().isEmpty() ? label + " " + paths.getFirst() : label,
          () -> ruic.show(choice, of(stream, paths)));
    } else {
      PopupMenu fields = menu.under(label);
      paths.stream().limit(MOST_FIELDS)
          .forEach(path -> fields.push(path, () -> ruic.show(choice, of(stream, List.of(path)))));
      fields.line().push("Choose among all\u2026", () -> ruic.show(choice, Subject.Stream.of(stream.port())));
    }
  }

  private static Subject.Stream of(Subject.Stream stream, List<String> fields) {
    return new Subject.Stream(stream.port(), fields);
  }

  /** The fields of a value that are numbers, or that hold some. */
  private static List<String> numbers(Envelope<?> newest, List<String> fields) {
    if (fields.isEmpty()) {
      return NumberPaths.of(DataRecord.of(newest.value()));
    }
    return fields.stream()
        .flatMap(field -> at(newest, field).stream().flatMap(value -> NumberPaths.at(field, value).stream())).toList();
  }

  /** A field by the name that we give, else by that of the robot. */
  private static Optional<FieldValue> at(Envelope<?> newest, String path) {
    FieldPath field = FieldPath.parse(path);
    return DataRecord.of(newest.value()).at(field).or(() -> newest.record().at(field));
  }

  private void stream(PopupMenu menu, Subject.Stream stream) {
    menu.push("Copy name", () -> Clipboards.copy(PortDrag.name(stream)));
    if (stream.fields().size() == 1) {
      field(menu, stream);
    } else if (ruic.newest(stream.port()).isEmpty()) {
      menu.unavailable("Copy value as YAML", "no value yet");
      menu.unavailable("Copy value as JSON", "no value yet");
    } else {
      menu.push("Copy value as YAML", () -> copy(stream.port(), RecordYaml::of));
      menu.push("Copy value as JSON", () -> copy(stream.port(), RecordJson::of));
    }
    type(stream.port()).ifPresent(type -> {
      menu.line();
      menu.push("Documentation of " + type,
          () -> TypeWindow.open(Display.getCurrent(), theme, type, ruic.newest(stream.port()).map(Envelope::record)));
    });
  }

  private void field(PopupMenu menu, Subject.Stream stream) {
    Optional<String> value = ruic.newest(stream.port()).flatMap(e -> value(e, stream.fields().getFirst()));
    value.ifPresentOrElse(text -> menu.push("Copy value", () -> Clipboards.copy(text)),
        () -> menu.unavailable("Copy value", "no value yet"));
  }

  private static Optional<String> value(Envelope<?> newest, String path) {
    return at(newest, path).map(value -> switch (value) {
      case FieldValue.Num n -> Scalars.yaml(n);
      case FieldValue.Flag f -> Boolean.toString(f.value());
      case FieldValue.Text t -> t.value();
      default -> RecordYaml.of(new MapRecord("", Map.of(path, value))).strip();
    });
  }

  private void copy(SourceId port, Function<DynamicRecord, String> writer) {
    Display display = Display.getCurrent();
    ruic.newest(port).ifPresent(newest -> background.execute(() -> {
      String text = writer.apply(newest.record());
      if (!display.isDisposed()) {
        display.asyncExec(() -> Clipboards.copy(text));
      }
    }));
  }

  private Optional<String> type(SourceId port) {
    return ruic.snapshot().ports().stream()
        .filter(status -> status.kind() == PortKind.STREAM && status.port().equals(port))
        .map(PortStatus::typeName).findFirst();
  }
}
