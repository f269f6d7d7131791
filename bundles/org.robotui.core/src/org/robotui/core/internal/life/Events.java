package org.robotui.core.internal.life;

import org.robotui.api.show.Subject;

/** Where the life of RUICs is reported. Methods never block. */
public interface Events {
  /** State, components or matches changed. */
  void changed(String ruic);

  /** A view has something new to show. */
  void frameReady(String ruic, String uic);

  /** The user wants to see another RUIC. */
  void showWanted(String from, String wanted);

  /** The user wants to see something in a view. */
  void viewWanted(String ruic, String uic, String showing, Subject subject);

  /** Something the user should know. */
  void alert(String ruic, String message);

  /** A RUIC has ended and is to be taken away. */
  void removed(RuicRuntime ruic);
}
