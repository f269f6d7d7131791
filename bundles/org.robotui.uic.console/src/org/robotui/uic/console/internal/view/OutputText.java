package org.robotui.uic.console.internal.view;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ReadText;
import org.robotui.uic.console.internal.model.ConsoleLine;
import org.robotui.uic.console.internal.model.Transcript;

/** What was typed and what came of it, the newest at the end. Display thread. */
final class OutputText {
  private static final int LINE_GAP = 2;

  private final StyledText text;
  private final Theme theme;
  private long begin;
  private long end;

  OutputText(Composite parent, Theme theme) {
    this.theme = theme;
    text = ReadText.in(parent, theme, SWT.WRAP);
    text.setLineSpacing(LINE_GAP);
  }

  StyledText control() {
    return text;
  }

  /** Adds what is new, and forgets what is gone. What the user looks at further up stays where it is. */
  void show(Transcript transcript) {
    Transcript.Part part = transcript.since(end);
    if (part.begin() != begin) { // of what has gone nobody knows the length
      part = transcript.since(0);
      text.setText("");
    } else if (part.lines().isEmpty()) {
      return;
    }
    boolean following = isAtEnd();
    append(part.lines());
    begin = part.begin();
    end = part.end();
    if (following) {
      text.setTopIndex(text.getLineCount() - 1);
    }
  }

  private void append(List<ConsoleLine> lines) {
    StringBuilder all = new StringBuilder();
    int start = text.getCharCount();
    StyleRange[] styles = new StyleRange[lines.size()];
    for (int i = 0; i < styles.length; i++) {
      String shown = lines.get(i).shown();
      styles[i] = new StyleRange(start + all.length(), shown.length(), theme.color(role(lines.get(i).kind())), null);
      all.append(shown).append('\n');
    }
    text.append(all.toString());
    for (StyleRange style : styles) {
      text.setStyleRange(style);
    }
  }

  private boolean isAtEnd() {
    int lastSeen = text.getLineIndex(text.getClientArea().height);
    return lastSeen >= text.getLineCount() - 2;
  }

  private static Role role(ConsoleLine.Kind kind) {
    return switch (kind) {
      case INPUT, RECORDED -> Role.ACCENT;
      case OUTPUT, VALUE -> Role.TEXT;
      case ERROR -> Role.BAD;
      case NOTE -> Role.DIM;
    };
  }
}
