/** The guarded side: starts the guard, greets it, and keeps it alive. */
package org.robotui.guard.internal.client;
