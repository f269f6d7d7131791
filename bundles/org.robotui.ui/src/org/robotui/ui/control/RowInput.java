package org.robotui.ui.control;

import java.util.function.Consumer;
import java.util.function.Predicate;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;

/** What keys and mouse do to a list. Display thread. */
final class RowInput<R> {
  Consumer<R> open = row -> {};
  Runnable find = () -> {};

  private final RowList<R> list;
  private Predicate<Event> keys = event -> false;
  private Predicate<Event> press = event -> false;
  private boolean several;
  private boolean pressedMarked;
  private boolean taken;

  RowInput(RowList<R> list) {
    this.list = list;
  }

  void listen(Canvas canvas) {
    canvas.addListener(SWT.MouseDown, this::down);
    canvas.addListener(SWT.MouseUp, this::up);
    canvas.addListener(SWT.MouseDoubleClick, this::doubled);
    canvas.addListener(SWT.MouseMove, this::moved);
    canvas.addListener(SWT.MouseExit, e -> list.hover(-1));
    canvas.addListener(SWT.KeyDown, this::key);
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  /** Has keys first go elsewhere; true says that nothing else is to be done. */
  void first(Predicate<Event> pressedKey, Predicate<Event> pressedMouse) {
    keys = pressedKey;
    press = pressedMouse;
  }

  void several() {
    several = true;
  }

  boolean isSeveral() {
    return several;
  }

  private int indexAt(Event event) {
    return list.scroll().indexAt(event.y);
  }

  private void down(Event event) {
    list.canvas().setFocus();
    int index = indexAt(event);
    taken = index >= 0 && press.test(event);
    if (index < 0 || taken) {
      return;
    }
    // A press on one of several selected rows may begin a drag of all, or open their menu; only the release tells.
    pressedMarked = several && plain(event) && list.marks().has(list.rows().get(index));
    if (!pressedMarked) {
      choose(index, event.stateMask);
    }
  }

  private void up(Event event) {
    int index = indexAt(event);
    if (pressedMarked && event.button == 1 && index >= 0) {
      choose(index, event.stateMask);
    }
    pressedMarked = false;
  }

  private void doubled(Event event) {
    if (!taken && event.button == 1) {
      open(indexAt(event));
    }
  }

  private static boolean plain(Event event) {
    return (event.stateMask & (SWT.MOD1 | SWT.SHIFT)) == 0;
  }

  private void choose(int index, int stateMask) {
    if (several && (stateMask & SWT.SHIFT) != 0) {
      list.marks().extend(index);
    } else if (several && (stateMask & SWT.MOD1) != 0) {
      list.marks().toggle(index);
    } else {
      list.marks().only(index);
    }
    list.chose(index);
  }

  private void moved(Event event) {
    int index = indexAt(event);
    list.hover(index);
    String hint = index < 0 ? "" : hint(index, event.x);
    String shown = hint.replace("&", "&&");
    if (!shown.equals(list.canvas().getToolTipText())) {
      list.canvas().setToolTipText(shown.isEmpty() ? null : shown);
    }
  }

  private String hint(int index, int x) {
    GC gc = new GC(list.canvas());
    try {
      return list.look().hint(gc, list.at(index), list.rows().get(index), x);
    } finally {
      gc.dispose();
    }
  }

  private void key(Event event) {
    // Keys with Alt are those of a view, such as moving a row itself.
    if (keys.test(event) || (event.stateMask & SWT.ALT) != 0) {
      return;
    }
    int at = list.marks().leadIndex();
    int page = list.scroll().page();
    switch (event.keyCode) {
      case SWT.ARROW_UP -> go(at - 1, event);
      case SWT.ARROW_DOWN -> go(at + 1, event);
      case SWT.PAGE_UP -> go(at - page, event);
      case SWT.PAGE_DOWN -> go(at + page, event);
      case SWT.HOME -> go(0, event);
      case SWT.END -> go(list.rows().size() - 1, event);
      case SWT.CR, SWT.KEYPAD_CR -> open(at);
      default -> shortcut(event);
    }
  }

  private void go(int wanted, Event event) {
    if (!list.rows().isEmpty()) {
      choose(Math.clamp(wanted, 0, list.rows().size() - 1), event.stateMask & SWT.SHIFT);
    }
  }

  private void shortcut(Event event) {
    boolean control = (event.stateMask & SWT.MOD1) != 0;
    if (control && event.keyCode == 'c') {
      list.copy();
    } else if (control && event.keyCode == 'a' && several) {
      list.marks().all();
      list.chose(list.marks().leadIndex());
    } else if (control && event.keyCode == 'f' || event.character == '/') {
      find.run();
    }
  }

  private void open(int index) {
    if (index >= 0) {
      open.accept(list.rows().get(index));
    }
  }
}
