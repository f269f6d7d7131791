/** How the shared memory is read. */
package org.robotui.xbot.internal;
