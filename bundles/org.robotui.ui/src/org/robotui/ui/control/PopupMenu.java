package org.robotui.ui.control;

import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Menu;
import org.eclipse.swt.widgets.MenuItem;
import org.robotui.ui.ViewAction;

/**
 * A menu that is made to be opened once and goes when it has closed. What follows a tab in a label is the key that does
 * the same; an ampersand is shown as it is. Display thread.
 */
public final class PopupMenu {
  private final Menu menu;
  private final Runnable after;

  /**
   * An empty menu.
   *
   * @param control whose menu it is
   */
  public PopupMenu(Control control) {
    this(control, () -> {});
  }

  /**
   * An empty menu.
   *
   * @param control whose menu it is
   * @param after is run after whatever was chosen, for example to paint anew
   */
  public PopupMenu(Control control, Runnable after) {
    this(new Menu(control.getShell(), SWT.POP_UP), after);
    // Selection is told after hiding, so the menu must live until then.
    menu.addListener(SWT.Hide, e -> menu.getDisplay().asyncExec(menu::dispose));
  }

  private PopupMenu(Menu menu, Runnable after) {
    this.menu = menu;
    this.after = after;
  }

  /**
   * Something to do.
   *
   * @param label its words
   * @param run does it
   * @return this
   */
  public PopupMenu push(String label, Runnable run) {
    return push(label, true, run);
  }

  /**
   * Something to do, or that cannot be done now.
   *
   * @param label its words
   * @param enabled whether it can be chosen
   * @param run does it
   * @return this
   */
  public PopupMenu push(String label, boolean enabled, Runnable run) {
    item(SWT.PUSH, label, item -> run.run()).setEnabled(enabled);
    return this;
  }

  /**
   * Something that cannot be done now, and why.
   *
   * @param label its words
   * @param reason a few words
   * @return this
   */
  public PopupMenu unavailable(String label, String reason) {
    MenuItem item = item(SWT.PUSH, label + "  (" + reason + ")", chosen -> {});
    item.setEnabled(false);
    return this;
  }

  /**
   * Something to switch.
   *
   * @param label its words
   * @param on whether it is on now
   * @param changed is told whether it is to be on
   * @return this
   */
  public PopupMenu check(String label, boolean on, Consumer<Boolean> changed) {
    item(SWT.CHECK, label, item -> changed.accept(item.getSelection())).setSelection(on);
    return this;
  }

  /**
   * One of several, of which one is so.
   *
   * @param label its words
   * @param on whether this is so now
   * @param chosen makes it so
   * @return this
   */
  public PopupMenu radio(String label, boolean on, Runnable chosen) {
    // The one that is left is told, too.
    item(SWT.RADIO, label, item -> {
      if (item.getSelection()) {
        chosen.run();
      }
    }).setSelection(on);
    return this;
  }

  /**
   * An action of a view.
   *
   * @param action with a check where it can be switched
   * @return this
   */
  public PopupMenu action(ViewAction action) {
    return action.checked().map(on -> check(action.label(), on.getAsBoolean(), now -> action.run().run()))
        .orElseGet(() -> push(action.label(), action.run()));
  }

  /**
   * A menu within this one.
   *
   * @param label its words
   * @return that menu
   */
  public PopupMenu under(String label) {
    MenuItem item = new MenuItem(menu, SWT.CASCADE);
    item.setText(shown(label));
    Menu sub = new Menu(menu);
    item.setMenu(sub);
    return new PopupMenu(sub, after);
  }

  /**
   * A line between what is above and what comes below, where there is something above.
   *
   * @return this
   */
  public PopupMenu line() {
    if (menu.getItemCount() > 0) {
      new MenuItem(menu, SWT.SEPARATOR);
    }
    return this;
  }

  /**
   * The menu of the toolkit, for example to look at its entries before it is opened.
   *
   * @return the widget
   */
  public Menu widget() {
    return menu;
  }

  /** Opens it at the pointer. */
  public void open() {
    menu.setVisible(true);
  }

  /**
   * Opens it at a point. A menu without entries goes at once.
   *
   * @param at on the display
   */
  public void open(Point at) {
    if (menu.getItemCount() == 0) {
      menu.dispose();
    } else {
      menu.setLocation(at);
      menu.setVisible(true);
    }
  }

  /**
   * Opens it below a control, as far to the left.
   *
   * @param control for example the button that was pressed
   */
  public void openBelow(Control control) {
    open(control.toDisplay(0, control.getSize().y));
  }

  private MenuItem item(int style, String label, Consumer<MenuItem> selected) {
    MenuItem item = new MenuItem(menu, style);
    item.setText(shown(label));
    item.addListener(SWT.Selection, e -> {
      selected.accept(item);
      after.run();
    });
    return item;
  }

  private static String shown(String label) {
    return label.replace("&", "&&");
  }
}
