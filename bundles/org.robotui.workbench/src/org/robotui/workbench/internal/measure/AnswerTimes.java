package org.robotui.workbench.internal.measure;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.LongConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.eclipse.swt.widgets.Text;
import org.robotui.workbench.internal.dock.SeenView;
import org.robotui.workbench.internal.pane.SearchPane;

/**
 * How soon the window answers its user: when each view that was opened was first seen, and how long the search takes
 * from a key until what it found is seen. Made on the display thread, told to any.
 */
final class AnswerTimes implements AutoCloseable {
  private final Display display;
  private final Map<String, Long> seen = new ConcurrentSkipListMap<>();
  private final Latencies opening = new Latencies();
  private final Latencies answering = new Latencies();
  private final Set<Control> known = Collections.newSetFromMap(new WeakHashMap<>());
  private final Listener pressed = event -> keyNanos = System.nanoTime();
  private final Listener changed = this::changed;
  private final Listener painted = this::painted;
  /** When the last key was pressed. */
  private long keyNanos;
  /** The search in which a text was changed and nothing was painted since. */
  private Optional<SearchPane> asked = Optional.empty();

  AnswerTimes(Display display) {
    this.display = display;
    display.addFilter(SWT.KeyDown, pressed);
    display.addFilter(SWT.Modify, changed);
    display.addFilter(SWT.Paint, painted);
  }

  @Override
  public void close() {
    if (!display.isDisposed()) {
      display.removeFilter(SWT.KeyDown, pressed);
      display.removeFilter(SWT.Modify, changed);
      display.removeFilter(SWT.Paint, painted);
    }
  }

  /**
   * When what a view made was first painted, milliseconds since 1970, by {@code robot UI/view}; of a view that was
   * opened several times the last one.
   */
  Map<String, Long> seen() {
    return seen;
  }

  /** From the key until the search is there. */
  Latencies opening() {
    return opening;
  }

  /** From a key that changes what is searched for until what was found is there. */
  Latencies answering() {
    return answering;
  }

  private void changed(Event event) {
    if (event.widget instanceof Text text) {
      asked = SearchPane.around(text);
    }
  }

  /** It is called before what it tells of is painted; the display does other tasks after that. */
  private void painted(Event event) {
    if (!(event.widget instanceof Control control)) {
      return;
    }
    SeenView.of(control).filter(view -> known.add(view.control()))
        .ifPresent(
            view -> display.asyncExec(() -> seen.put(view.ruic() + "/" + view.id(), System.currentTimeMillis())));
    if (!(control instanceof Text)) {
      SearchPane.around(control).ifPresent(this::painted);
    }
  }

  private void painted(SearchPane search) {
    if (known.add(search)) {
      asked = Optional.empty();
      later(opening::add);
    } else if (asked.filter(pane -> pane == search).isPresent()) {
      asked = Optional.empty();
      later(answering::add);
    }
  }

  private void later(LongConsumer told) {
    long since = keyNanos;
    display.asyncExec(() -> told.accept(System.nanoTime() - since));
  }
}
