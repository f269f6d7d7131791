package org.robotui.workbench.internal.pane;

import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.ui.control.PopupMenu;

/** Which of several robots the user controls, to take or release one, or to release all. Display thread only. */
public final class LeaseMenu {
  private final Control control;
  private final Principal user;
  private final Consumer<Authority> change;

  /**
   * A menu that is not open.
   *
   * @param control whose menu it is
   * @param user who chooses
   * @param change takes control of a robot, or releases it where the user has it
   */
  public LeaseMenu(Control control, Principal user, Consumer<Authority> change) {
    this.control = control;
    this.user = user;
    this.change = change;
  }

  /** Opens it at the pointer. */
  public void open(List<Authority> robots) {
    of(robots).open();
  }

  PopupMenu of(List<Authority> robots) {
    PopupMenu menu = new PopupMenu(control);
    List<Authority> yours = robots.stream().filter(this::isYours).toList();
    if (yours.size() > 1) {
      menu.push("Release all " + yours.size() + " that you control", () -> yours.forEach(change)).line();
    }
    robots.forEach(robot -> menu.check(words(robot), isYours(robot), on -> change.accept(robot)));
    return menu;
  }

  private String words(Authority robot) {
    return "Control " + robot.robot() + robot.holder().filter(holder -> !holder.equals(user))
        .map(holder -> "  (" + holder.label() + " controls it)").orElse("");
  }

  private boolean isYours(Authority robot) {
    return robot.holder().filter(user::equals).isPresent();
  }
}
