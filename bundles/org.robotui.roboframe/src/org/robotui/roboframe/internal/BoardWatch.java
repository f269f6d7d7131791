package org.robotui.roboframe.internal;

/** Is told what happens on a blackboard, on the thread that does it; must not block. */
public interface BoardWatch {

  /** Other keys are used, or by others. */
  void changed();

  /** How many others are sent the values of a key. */
  int readers(String key);

  /** A module here has written something. */
  void posted(Outgoing value);
}
