/**
 * Roblets, and what runs them: they start, run with a frequency, take messages, fail and are started again. Each has
 * two threads from a factory that is given.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.roblet;
