package org.robotui.workbench.internal.rcp;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.jface.action.Action;
import org.eclipse.jface.action.ActionContributionItem;
import org.eclipse.jface.action.IAction;
import org.eclipse.jface.action.IContributionItem;
import org.eclipse.jface.action.Separator;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.actions.CompoundContributionItem;
import org.eclipse.ui.menus.IWorkbenchContribution;
import org.eclipse.ui.services.IServiceLocator;
import org.robotui.api.host.Arranging;
import org.robotui.api.host.Arranging.Perspective;
import org.robotui.workbench.internal.WorkbenchServices;

/** In the menu Perspective: the named arrangements of the robot that the window shows, and what can be done to them. */
public final class PerspectiveItems extends CompoundContributionItem implements IWorkbenchContribution {
  private IServiceLocator locator;

  @Override
  public void initialize(IServiceLocator serviceLocator) {
    locator = serviceLocator;
  }

  @Override
  protected IContributionItem[] getContributionItems() {
    return WindowActions.layoutOf(locator.getService(IWorkbenchWindow.class)).map(PerspectiveItems::items)
        .orElse(new IContributionItem[0]);
  }

  private static IContributionItem[] items(LayoutActions layout) {
    Arranging arranging = layout.surface().docking().arranging();
    Map<String, Perspective> all = arranging.perspectives();
    Optional<String> chosen = arranging.perspective();
    List<IContributionItem> items = new ArrayList<>();
    int number = 0;
    for (String name : all.keySet()) {
      number++;
      items.add(item(label(name, number, chosen, all, arranging), chosen.filter(name::equals).isPresent(),
          () -> layout.surface().docking().choose(name)));
    }
    items.add(new Separator());
    items.add(item("Save Perspective As...", false, layout::keep));
    chosen.filter(name -> !all.get(name).written()).ifPresent(name -> {
      items.add(item("Rename '" + name + "'...", false, () -> layout.rename(name)));
      items.add(item("Delete '" + name + "'...", false, () -> layout.forget(name)));
    });
    chosen.ifPresent(name -> items.add(item("Export '" + name + "'...", false, () -> layout.export(name))));
    items.add(item("Import Perspective...", false, layout::take));
    return items.toArray(IContributionItem[]::new);
  }

  /** One that was chosen and changed since says so: choosing it again has it as it was. */
  private static String label(String name, int number, Optional<String> chosen, Map<String, Perspective> all,
      Arranging arranging) {
    boolean changed = chosen.filter(name::equals).isPresent() && !all.get(name).arrangement().liesAs(arranging.now());
    return name + (changed ? " (changed)" : "") + keyOf(number);
  }

  private static String keyOf(int number) {
    String key = WorkbenchServices.session().keys().text("perspective(" + number + ")");
    return key.isEmpty() ? "" : "\t" + key;
  }

  private static ActionContributionItem item(String label, boolean checked, Runnable run) {
    Action action = new Action(label, checked ? IAction.AS_CHECK_BOX : IAction.AS_PUSH_BUTTON) {
      @Override
      public void run() {
        run.run();
      }
    };
    action.setChecked(checked);
    return new ActionContributionItem(action);
  }
}
