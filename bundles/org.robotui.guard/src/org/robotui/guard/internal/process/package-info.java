/** The process of a guard. It uses nothing but the Java runtime, and one thread for all connections. */
package org.robotui.guard.internal.process;
