package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.eclipse.jface.preference.PreferencePage;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchPreferencePage;
import org.eclipse.ui.keys.IBindingService;
import org.robotui.ui.ViewKey;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.WorkbenchSession;
import org.robotui.workbench.internal.dock.ViewEntry;
import org.robotui.workbench.internal.pane.KeyRecorder;
import org.robotui.workbench.internal.pane.KeysPane;

/** The keys of all commands, among the preferences. */
public final class KeysPage extends PreferencePage implements IWorkbenchPreferencePage {
  private static final int HEIGHT = 420;
  private static final int WIDTH = 680;

  private final WorkbenchSession session = WorkbenchServices.session();
  private IWorkbench workbench;

  @Override
  public void init(IWorkbench platform) {
    workbench = platform;
    noDefaultAndApplyButton();
  }

  @Override
  protected Control createContents(Composite parent) {
    IBindingService bindings = workbench.getService(IBindingService.class);
    session.keys().commands(new CommandCatalog(workbench).all().keySet().stream().toList());
    Composite place = Trim.place(parent);
    new Rebuilt<>(place, session, (within, theme) -> new KeysPane(within, theme, session.keys(), this::views,
        new KeyRecorder(parent.getDisplay(), silent -> bindings.setKeyFilterEnabled(!silent))), pane -> {});
    GridData data = new GridData(GridData.FILL_BOTH);
    data.heightHint = HEIGHT;
    data.widthHint = WIDTH;
    place.setLayoutData(data);
    place.getDisplay().asyncExec(() -> focus(place));
    return place;
  }

  /** The platform gives the keys to its list of pages. */
  private static void focus(Composite place) {
    if (!place.isDisposed()) {
      place.getChildren()[0].setFocus();
    }
  }

  private Map<String, List<ViewKey>> views() {
    Map<String, List<ViewKey>> keys = new LinkedHashMap<>();
    Arrays.stream(workbench.getWorkbenchWindows()).flatMap(window -> RobotPart.in(window).stream())
        .flatMap(part -> part.area().surface().stream()).flatMap(surface -> surface.views().stream())
        .forEach((ViewEntry view) -> keys.put(view.title(), view.keys()));
    return keys;
  }
}
