package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import java.util.Optional;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.jface.bindings.keys.SWTKeySupport;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbench;
import org.eclipse.ui.IWorkbenchWindow;
import org.robotui.workbench.internal.dock.ViewWindow;
import org.robotui.workbench.internal.keys.KeyStore;
import org.robotui.workbench.internal.keys.KeyedCommand;

/**
 * Has keys run commands in windows of views as they do in main windows. The platform takes every window that it has not
 * made for a dialog, in which its keys do not hold. Display thread only.
 */
final class ViewWindowKeys {
  private final IWorkbench workbench;
  private final KeyStore store;

  private ViewWindowKeys(IWorkbench workbench, KeyStore store) {
    this.workbench = workbench;
    this.store = store;
  }

  /** Listens as long as the display lives; after the platform, which has its filter already. */
  static void follow(IWorkbench workbench, KeyStore store) {
    workbench.getDisplay().addFilter(SWT.KeyDown, new ViewWindowKeys(workbench, store)::key);
  }

  private void key(Event event) {
    if (event.doit && event.widget instanceof Control control && ViewWindow.isOne(control.getShell())) {
      KeySequence keys = KeySequence.getInstance(
          SWTKeySupport.convertAcceleratorToKeyStroke(SWTKeySupport.convertEventToUnmodifiedAccelerator(event)));
      Optional.ofNullable(store.now().bound().get(keys)).filter(command -> !command.fixed()).ifPresent(command -> {
        event.doit = false;
        windowOf(control.getShell()).ifPresent(window -> run(window, command));
      });
    }
  }

  private Optional<IWorkbenchWindow> windowOf(Shell views) {
    return Arrays.stream(workbench.getWorkbenchWindows()).filter(w -> w.getShell() == views.getParent()).findFirst();
  }

  private static void run(IWorkbenchWindow window, KeyedCommand command) {
    Optional.ofNullable(new CommandCatalog(window).all().get(command))
        .ifPresent(new WorkbenchCommands(window)::run);
  }
}
