/** Reads YAML configurations: every problem names file, line, column, what was expected, and the nearest valid word. */
package org.robotui.core.internal.config;
