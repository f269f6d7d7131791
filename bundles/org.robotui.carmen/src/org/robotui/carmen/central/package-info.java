/**
 * A small central of IPC, for simulated robots and tests: modules link to it, register messages, handle and publish
 * them, ask and answer. It speaks what was recorded of CARMEN's own; programs of CARMEN were never linked to it.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.carmen.central;
