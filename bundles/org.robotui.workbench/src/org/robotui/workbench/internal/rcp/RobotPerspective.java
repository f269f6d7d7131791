package org.robotui.workbench.internal.rcp;

import org.eclipse.ui.IPageLayout;
import org.eclipse.ui.IPerspectiveFactory;

/** Navigator at the left, the robot's views in the rest; whatever else is opened comes below. */
public final class RobotPerspective implements IPerspectiveFactory {
  /** As in plugin.xml. */
  static final String ID = "org.robotui.workbench.perspective";

  private static final float NAVIGATOR_SHARE = 0.155f;
  private static final float BELOW_SHARE = 0.7f;
  private static final String LOG_VIEW = "org.eclipse.pde.runtime.LogView";

  @Override
  public void createInitialLayout(IPageLayout layout) {
    layout.setEditorAreaVisible(false);
    String area = layout.getEditorArea();
    layout.addStandaloneView(NavigatorPart.ID, false, IPageLayout.LEFT, NAVIGATOR_SHARE, area);
    layout.addStandaloneView(RobotPart.ID, false, IPageLayout.TOP, IPageLayout.RATIO_MAX, area);
    layout.createPlaceholderFolder("below", IPageLayout.BOTTOM, BELOW_SHARE, RobotPart.ID).addPlaceholder(LOG_VIEW);
    layout.getViewLayout(NavigatorPart.ID).setCloseable(false);
    layout.getViewLayout(RobotPart.ID).setCloseable(false);
    layout.addShowViewShortcut(LOG_VIEW);
  }
}
