package org.robotui.uic.topics.internal.view;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.swt.custom.StyledText;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.ReadText;

/** The definition of a type, with comments, types and constants in quiet colours. Display thread. */
final class DefinitionText {
  private static final int MOST = 200_000;
  private static final Pattern COMMENT = Pattern.compile("#[^\n]*");
  private static final Pattern TYPE = Pattern.compile("(?m)^[ \t]*([A-Za-z][\\w/]*(?:\\[\\d*])?)[ \t]+[A-Za-z]\\w*");
  private static final Pattern PART = Pattern.compile("(?m)^(?:=+|-+|MSG:.*)$");

  private final StyledText text;
  private final Theme theme;
  private String shown = "";

  DefinitionText(Composite parent, Theme theme) {
    this.theme = theme;
    text = ReadText.in(parent, theme, SWT.H_SCROLL);
  }

  Control control() {
    return text;
  }

  void show(String definition) {
    String next = definition.length() > MOST ? definition.substring(0, MOST) + "\n# and more" : definition;
    if (!next.equals(shown)) {
      shown = next;
      text.setText(next);
      text.setStyleRanges(styles(next).toArray(StyleRange[]::new));
    }
  }

  private List<StyleRange> styles(String definition) {
    Role[] roles = new Role[definition.length()];
    mark(roles, TYPE.matcher(definition), 1, Role.ACCENT);
    mark(roles, PART.matcher(definition), 0, Role.DIM);
    mark(roles, COMMENT.matcher(definition), 0, Role.DIM);
    List<StyleRange> styles = new ArrayList<>();
    int start = 0;
    for (int i = 1; i <= roles.length; i++) {
      if (i == roles.length || roles[i] != roles[start]) {
        if (roles[start] != null) {
          styles.add(new StyleRange(start, i - start, theme.color(roles[start]), null));
        }
        start = i;
      }
    }
    return styles;
  }

  private static void mark(Role[] roles, Matcher found, int group, Role role) {
    while (found.find()) {
      Arrays.fill(roles, found.start(group), found.end(group), role);
    }
  }
}
