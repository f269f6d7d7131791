package org.robotui.uic.console.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.custom.VerifyKeyListener;
import org.eclipse.swt.events.VerifyEvent;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.script.ScriptSession.Completion;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.PopupMenu;
import org.robotui.uic.console.internal.model.InputHistory;
import org.robotui.uic.console.internal.model.OpenBrackets;

/** Where the user types: one line or more. Display thread. */
final class ScriptField {
  private static final int MOST_CHOICES = 20;
  private static final String PLACEHOLDER = "Enter runs, Tab completes, arrow up brings back";

  private final StyledText text;
  private final InputHistory history;
  private final ConsoleHands hands;
  private boolean running;

  ScriptField(Composite parent, Theme theme, InputHistory history, ConsoleHands hands) {
    this.history = history;
    this.hands = hands;
    text = Boxes.ownColours(new StyledText(parent, SWT.MULTI | SWT.V_SCROLL | SWT.WRAP));
    text.setAlwaysShowScrollBars(false);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setSelectionBackground(theme.mix(Role.ACCENT, Role.GROUND, 0.3));
    text.setSelectionForeground(theme.color(Role.TEXT));
    text.setMargins(2 * Theme.STEP, Theme.STEP, 2 * Theme.STEP, Theme.STEP);
    text.addListener(SWT.Paint, e -> {
      if (text.getCharCount() == 0) {
        e.gc.setForeground(theme.color(Role.DIM));
        e.gc.drawText(PLACEHOLDER, text.getLeftMargin(), text.getTopMargin(), true);
      }
    });
    text.setKeyBinding(SWT.TAB, SWT.NULL);
    text.addVerifyKeyListener((VerifyKeyListener) this::key);
    text.addListener(SWT.Traverse, e -> e.doit = e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
    text.addListener(SWT.Modify, e -> text.redraw()); // the placeholder comes and goes
  }

  StyledText control() {
    return text;
  }

  void running(boolean now) {
    running = now;
  }

  private void key(VerifyEvent event) {
    boolean plain = event.stateMask == 0;
    event.doit = false;
    switch (event.keyCode) {
      case SWT.CR, SWT.LF, SWT.KEYPAD_CR -> enter(plain);
      case SWT.TAB -> complete();
      case SWT.ESC -> escape();
      case SWT.ARROW_UP -> event.doit = !plain || !older();
      case SWT.ARROW_DOWN -> event.doit = !plain || !newer();
      default -> event.doit = true;
    }
  }

  private void enter(boolean plain) {
    String typed = text.getText();
    if (!plain || OpenBrackets.in(typed) && text.getCaretOffset() == typed.length()) {
      text.insert("\n");
      text.setCaretOffset(text.getCaretOffset() + 1);
      text.showSelection();
    } else if (!typed.isBlank()) {
      history.add(typed.strip());
      text.setText("");
      hands.run(typed.strip(), history.all());
    }
  }

  private void escape() {
    if (running) {
      hands.stop();
    } else {
      text.setText("");
    }
  }

  private boolean older() {
    return text.getLineAtOffset(text.getCaretOffset()) == 0 && replaced(history.older(text.getText()));
  }

  private boolean newer() {
    return text.getLineAtOffset(text.getCaretOffset()) == text.getLineCount() - 1 && replaced(history.newer());
  }

  private boolean replaced(Optional<String> by) {
    by.ifPresent(words -> {
      text.setText(words);
      text.setCaretOffset(words.length());
    });
    return by.isPresent();
  }

  private void complete() {
    int caret = text.getCaretOffset();
    int begin = text.getOffsetAtLine(text.getLineAtOffset(caret));
    String line = text.getText().substring(begin, caret);
    Completion found = hands.complete(line);
    String typed = line.substring(Math.min(found.start(), line.length()));
    String common = common(found.words());
    if (common.length() > typed.length()) {
      put(begin + found.start(), caret, common);
    } else if (found.words().size() > 1) {
      choose(begin + found.start(), caret, found.words());
    }
  }

  private void put(int from, int to, String word) {
    text.replaceTextRange(from, to - from, word);
    text.setCaretOffset(from + word.length());
  }

  private void choose(int from, int to, List<String> words) {
    PopupMenu menu = new PopupMenu(text);
    words.stream().limit(MOST_CHOICES).forEach(word -> menu.push(word, () -> put(from, to, word)));
    if (words.size() > MOST_CHOICES) {
      menu.line().unavailable((words.size() - MOST_CHOICES) + " more", "type on");
    }
    Point at = text.getLocationAtOffset(from);
    menu.open(text.toDisplay(at.x, at.y + text.getLineHeight()));
  }

  private static String common(List<String> words) {
    String common = words.isEmpty() ? "" : words.getFirst();
    for (String word : words) {
      while (!word.startsWith(common)) {
        common = common.substring(0, common.length() - 1);
      }
    }
    return common;
  }
}
