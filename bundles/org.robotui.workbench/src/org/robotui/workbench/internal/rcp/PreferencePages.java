package org.robotui.workbench.internal.rcp;

import java.util.Arrays;
import java.util.Optional;
import org.eclipse.jface.preference.IPreferenceNode;
import org.eclipse.jface.preference.PreferenceManager;

/**
 * Leaves out the pages of the platform that are for editors and perspectives, which are not here, and its page of keys,
 * in whose place there is ours. What other plug-ins have put below them comes to the top.
 */
final class PreferencePages {
  private static final String GENERAL = "org.eclipse.ui.preferencePages.Workbench";
  private static final String PLATFORM = "org.eclipse.ui.preferencePages.";

  private PreferencePages() {}

  static void tidy(PreferenceManager pages) {
    Optional.ofNullable(pages.remove(GENERAL)).ifPresent(general -> keep(general, pages));
  }

  private static void keep(IPreferenceNode left, PreferenceManager pages) {
    Arrays.stream(left.getSubNodes()).forEach(node -> {
      if (node.getId().startsWith(PLATFORM)) {
        keep(node, pages);
      } else {
        pages.addToRoot(node);
      }
    });
  }
}
