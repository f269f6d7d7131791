package org.robotui.workbench.internal.rcp;

import org.eclipse.e4.ui.model.application.ui.MUIElement;
import org.eclipse.e4.ui.model.application.ui.SideValue;
import org.eclipse.e4.ui.model.application.ui.basic.MTrimBar;
import org.eclipse.e4.ui.model.application.ui.basic.MTrimElement;
import org.eclipse.e4.ui.model.application.ui.basic.MTrimmedWindow;
import org.eclipse.e4.ui.model.application.ui.menu.MToolControl;
import org.eclipse.e4.ui.workbench.modeling.EModelService;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.IWorkbenchWindow;

/**
 * Puts our bar at the top of a window and our line at its bottom; the 3.x API has no place for a whole bar of our own.
 */
final class Trim {
  /** Has the platform give a control the rest of the line. */
  private static final String STRETCH = "stretch";
  private static final String CLASSES = "bundleclass://org.robotui.workbench/";

  private Trim() {}

  static void add(IWorkbenchWindow window) {
    MTrimmedWindow model = (MTrimmedWindow) window.getService(MTrimmedWindow.class);
    EModelService service = window.getService(EModelService.class);
    add(service, model, SideValue.TOP, "org.robotui.workbench.top", TopControl.class);
    add(service, model, SideValue.BOTTOM, "org.robotui.workbench.bottom", StatusControl.class);
  }

  /** Whether the list of robots has its place at the left. */
  static void navigator(IWorkbenchWindow window, boolean seen) {
    MTrimmedWindow model = (MTrimmedWindow) window.getService(MTrimmedWindow.class);
    MUIElement navigator = window.getService(EModelService.class).find(NavigatorPart.ID, model);
    if (navigator != null) {
      MUIElement place = navigator.getCurSharedRef() == null ? navigator : navigator.getCurSharedRef();
      place.setVisible(seen);
    }
  }

  private static void add(EModelService service, MTrimmedWindow window, SideValue side, String id, Class<?> type) {
    MTrimBar bar = service.getTrim(window, side);
    if (bar.getChildren().stream().anyMatch(c -> id.equals(c.getElementId()))) {
      return;
    }
    MToolControl control = service.createModelElement(MToolControl.class);
    control.setElementId(id);
    control.setContributionURI(CLASSES + type.getName());
    control.getTags().add(STRETCH);
    bar.getChildren().forEach(Trim::hide);
    bar.getChildren().add(0, control);
    bar.setToBeRendered(true);
    bar.setVisible(true);
  }

  /** The control that the platform places: it stays when what is in it is made anew. */
  static Composite place(Composite bar) {
    Composite place = new Composite(bar, SWT.NONE);
    place.setLayout(new FillLayout());
    return place;
  }

  /** Takes away what the platform has made all the same while the window opened, such as its own status line. */
  static void tidy(IWorkbenchWindow window) {
    MTrimmedWindow model = (MTrimmedWindow) window.getService(MTrimmedWindow.class);
    model.getTrimBars().stream().flatMap(bar -> bar.getChildren().stream())
        .filter(element -> !element.isToBeRendered() && element.getWidget() instanceof Control)
        .map(element -> (Control) element.getWidget())
        .filter(control -> !control.isDisposed())
        .forEach(Control::dispose);
    model.getTrimBars().forEach(Trim::fill);
  }

  /** What the platform placed beside ours may be gone already, while our lines have not got its room yet. */
  private static void fill(MTrimBar bar) {
    if (bar.getWidget() instanceof Composite line && !line.isDisposed()) {
      line.layout(true, true);
    }
  }

  /** What the platform keeps there, such as spacers, would take its share of the line. */
  private static void hide(MTrimElement element) {
    element.getTags().remove(STRETCH);
    element.setToBeRendered(false);
  }
}
