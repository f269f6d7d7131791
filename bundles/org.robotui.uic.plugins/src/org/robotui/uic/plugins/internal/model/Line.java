package org.robotui.uic.plugins.internal.model;

import org.robotui.ui.Health;

/** A line of the list. */
public sealed interface Line permits LoopLine, PluginLine, DrivesLine {
  /** What identifies it, so that it stays selected while others come and go. */
  String key();

  /** How it is doing. */
  Health health();

  /** What it is called. */
  String name();

  /** How it is doing, in a word or two. */
  String word();

  /** More of that. */
  String words();

  /** How long one call or cycle took. */
  Evidence busy();

  /** How long it may take, nanoseconds; 0 where that is not known. */
  long period();
}
