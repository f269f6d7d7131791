package org.robotui.ui.show;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.graphics.Font;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.TypeDoc;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A small window that says what a type of data means: its fields with their units, and what the robot's own message is
 * made of. Display thread.
 */
final class TypeWindow {
  private static final int WIDTH = 560;
  private static final int HEIGHT = 460;
  private static final int INDENT = 16;
  private static final int DEEPEST = 6;

  private final Theme theme;
  private final StringBuilder text = new StringBuilder();
  private final List<StyleRange> styles = new ArrayList<>();
  private final List<Integer> indented = new ArrayList<>();

  private TypeWindow(Theme theme) {
    this.theme = theme;
  }

  /** Opens it over the window that is used now; Esc closes it. */
  static Shell open(Display display, Theme theme, String type, Optional<DynamicRecord> own) {
    Shell parent = display.getActiveShell();
    Shell shell = parent == null ? new Shell(display, SWT.SHELL_TRIM) : new Shell(parent, SWT.DIALOG_TRIM | SWT.RESIZE);
    shell.setText("Documentation of " + type);
    shell.setLayout(new FillLayout());
    new TypeWindow(theme).fill(shell, type, own);
    Rectangle over = parent == null ? display.getPrimaryMonitor().getClientArea() : parent.getBounds();
    shell.setBounds(over.x + (over.width - WIDTH) / 2, over.y + (over.height - HEIGHT) / 2, Math.min(WIDTH, over.width),
        Math.min(HEIGHT, over.height));
    shell.open();
    return shell;
  }

  private void fill(Shell shell, String type, Optional<DynamicRecord> own) {
    List<TypeDoc> docs = TypeDoc.find(type);
    docs.forEach(this::type);
    if (docs.isEmpty()) {
      words(type, Face.BODY_STRONG, Role.TEXT);
      line(
          "\nA message of the robot that no data type stands for. Its fields have the names and units that the robot gives them.\n");
    }
    own.filter(record -> !record.schema().equals(type)).ifPresent(this::message);
    StyledText area = new StyledText(shell, SWT.READ_ONLY | SWT.MULTI | SWT.WRAP | SWT.V_SCROLL);
    area.setAlwaysShowScrollBars(false);
    area.setFont(theme.font(Face.BODY));
    area.setBackground(theme.color(Role.PANEL));
    area.setForeground(theme.color(Role.TEXT));
    area.setSelectionBackground(theme.mix(Role.ACCENT, Role.PANEL, 0.3));
    area.setSelectionForeground(theme.color(Role.TEXT));
    area.setMargins(INDENT, INDENT, INDENT, INDENT);
    area.setLineSpacing(2);
    area.setCaret(null);
    area.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        shell.close();
      }
    });
    area.setText(text.toString());
    area.setStyleRanges(styles.toArray(StyleRange[]::new));
    indented.forEach(at -> {
      area.setLineIndent(area.getLineAtOffset(at), 1, INDENT);
      area.setLineWrapIndent(area.getLineAtOffset(at), 1, 2 * INDENT);
    });
  }

  private void type(TypeDoc doc) {
    gap();
    words(doc.name(), Face.BODY_STRONG, Role.TEXT);
    line("\n" + doc.text() + "\n");
    doc.fields().forEach(field -> field(field.name(), field.type(), field.text()));
  }

  /** The names of the robot, where they are others than ours. */
  private void message(DynamicRecord own) {
    gap();
    words(own.schema(), Face.BODY_STRONG, Role.TEXT);
    line("\nThe message as the robot sends it.\n");
    record("", own, 0);
  }

  private void record(String prefix, DynamicRecord record, int depth) {
    for (String name : record.fields()) {
      FieldValue value = record.field(name).orElse(new FieldValue.Text(""));
      if (value instanceof FieldValue.Nested nested && depth < DEEPEST) {
        field(prefix + name, nested.value().schema(), "");
        record(prefix + name + ".", nested.value(), depth + 1);
      } else {
        field(prefix + name, word(value), "");
      }
    }
  }

  private static String word(FieldValue value) {
    return switch (value) {
      case FieldValue.Num n -> "number";
      case FieldValue.Flag f -> "true or false";
      case FieldValue.Text t -> "text";
      case FieldValue.Time t -> "time";
      case FieldValue.Numbers n -> "numbers";
      case FieldValue.Items i -> "list";
      case FieldValue.Nested n -> n.value().schema();
    };
  }

  private void field(String name, String type, String meaning) {
    indented.add(text.length());
    words(name, Face.FIGURES, Role.ACCENT);
    words("  " + type, Face.SMALL, Role.DIM);
    line(meaning.isEmpty() ? "\n" : "  " + meaning + "\n");
  }

  private void gap() {
    if (!text.isEmpty()) {
      line("\n");
    }
  }

  private void line(String words) {
    text.append(words);
  }

  private void words(String words, Face face, Role role) {
    StyleRange style = new StyleRange(text.length(), words.length(), theme.color(role), null);
    Font font = theme.font(face);
    style.font = font;
    styles.add(style);
    text.append(words);
  }
}
