/**
 * Modules of IPC: programs that are linked to a central, publish messages, subscribe to them, ask and answer. Programs
 * that look and programs that serve are the same kind. What blocks says so; handlers run on the thread that reads a
 * link and must not block. A link that has ended stays so: a new module begins anew.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.carmen.module;
