package org.robotui.workbench.internal.dock;

import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;

/**
 * A composite that is no part of what is laid out, and not seen until it is shown. Not a plain composite, which style
 * sheets would colour. Display thread only.
 */
final class Aside extends Composite {
  Aside(Composite parent) {
    super(parent, SWT.NONE);
    setVisible(false);
  }
}
