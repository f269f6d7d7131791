/** What this process and its guard say to each other. */
package org.robotui.guard.internal.wire;
