package org.robotui.workbench.internal.rcp;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Theme;
import org.robotui.workbench.internal.WorkbenchSession;

/**
 * A control that is kept up to date, and made anew when the theme changes. It ends with its parent. Display thread
 * only.
 *
 * @param <C> the control
 */
final class Rebuilt<C extends Control> {
  private final Composite parent;
  private final WorkbenchSession session;
  private final BiFunction<Composite, Theme, C> maker;
  private final Consumer<C> refresher;
  private C control;

  Rebuilt(Composite parent, WorkbenchSession session, BiFunction<Composite, Theme, C> maker, Consumer<C> refresher) {
    this.parent = parent;
    this.session = session;
    this.maker = maker;
    this.refresher = refresher;
    control = make();
    List<Runnable> ends = List.of(session.look().onChange(this::rebuild), session.onRefresh(this::refresh));
    parent.addListener(SWT.Dispose, e -> ends.forEach(Runnable::run));
  }

  C control() {
    return control;
  }

  void refresh() {
    if (!control.isDisposed()) {
      refresher.accept(control);
    }
  }

  private C make() {
    C made = maker.apply(parent, session.look().theme());
    refresher.accept(made);
    return made;
  }

  private void rebuild() {
    if (!parent.isDisposed()) {
      control.dispose();
      control = make();
      parent.layout(true);
    }
  }
}
